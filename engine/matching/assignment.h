#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace ossuary::matching {

/// Minimum-cost bipartite assignment by the Hungarian method (Kuhn 1955, with the potentials and
/// shortest augmenting paths of Jonker and Volgenant 1987). Keeps its buffers between calls.
class Assignment {
public:
    /// Gives every row a column of its own so that the sum of costs is least. O(rows^2 columns).
    /// @param costs  row by row, finite
    /// @param stop   once asked to stop, any assignment is given
    /// @pre rows <= columns
    /// @return the column of each row; valid until the next call
    std::span<const std::uint32_t> solve(std::span<const float> costs, std::size_t rows,
                                         std::size_t columns, const std::stop_token& stop = {});

private:
    void solve_two_rows(std::span<const float> costs, std::size_t columns);

    std::vector<std::uint32_t> column_of_row_;
    std::vector<std::uint32_t> row_of_column_;  // one-based; 0 = free
    std::vector<std::uint32_t> way_;
    std::vector<double> row_potential_;
    std::vector<double> column_potential_;
    std::vector<double> slack_;
    std::vector<char> visited_;
};

}  // namespace ossuary::matching
