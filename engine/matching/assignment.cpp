#include "engine/matching/assignment.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace ossuary::matching {

std::span<const std::uint32_t> Assignment::solve(std::span<const float> costs, std::size_t rows,
                                                 std::size_t columns, const std::stop_token& stop) {
    assert(rows <= columns && costs.size() >= rows * columns);
    column_of_row_.resize(rows);
    if (rows == 0) return column_of_row_;
    if (rows == 1) {
        const auto least =
            std::min_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(columns));
        column_of_row_[0] = static_cast<std::uint32_t>(least - costs.begin());
        return column_of_row_;
    }
    if (rows == 2) {
        solve_two_rows(costs, columns);
        return column_of_row_;
    }
    row_potential_.assign(rows + 1, 0.0);
    column_potential_.assign(columns + 1, 0.0);
    row_of_column_.assign(columns + 1, 0);
    way_.assign(columns + 1, 0);
    for (std::size_t row = 1; row <= rows; ++row) {
        if (stop.stop_requested()) {
            std::iota(column_of_row_.begin(), column_of_row_.end(), 0U);
            return column_of_row_;
        }
        row_of_column_[0] = static_cast<std::uint32_t>(row);
        slack_.assign(columns + 1, std::numeric_limits<double>::infinity());
        visited_.assign(columns + 1, 0);
        std::size_t column = 0;
        do {
            visited_[column] = 1;
            const std::size_t current = row_of_column_[column];
            double delta = std::numeric_limits<double>::infinity();
            std::size_t nearest = 0;
            for (std::size_t j = 1; j <= columns; ++j) {
                if (visited_[j] != 0) continue;
                const double reduced = static_cast<double>(costs[(current - 1) * columns + j - 1]) -
                                       row_potential_[current] - column_potential_[j];
                if (reduced < slack_[j]) {
                    slack_[j] = reduced;
                    way_[j] = static_cast<std::uint32_t>(column);
                }
                if (slack_[j] < delta) {
                    delta = slack_[j];
                    nearest = j;
                }
            }
            for (std::size_t j = 0; j <= columns; ++j) {
                if (visited_[j] != 0) {
                    row_potential_[row_of_column_[j]] += delta;
                    column_potential_[j] -= delta;
                } else {
                    slack_[j] -= delta;
                }
            }
            column = nearest;
        } while (row_of_column_[column] != 0);
        while (column != 0) {
            const std::size_t before = way_[column];
            row_of_column_[column] = row_of_column_[before];
            column = before;
        }
    }
    for (std::size_t j = 1; j <= columns; ++j) {
        if (row_of_column_[j] != 0) {
            column_of_row_[row_of_column_[j] - 1] = static_cast<std::uint32_t>(j - 1);
        }
    }
    return column_of_row_;
}

void Assignment::solve_two_rows(std::span<const float> costs, std::size_t columns) {
    // The best pairing uses the best or the second best column of each row.
    std::size_t best[2] = {0, 0};
    std::size_t second[2] = {columns, columns};
    for (std::size_t row = 0; row < 2; ++row) {
        const std::span<const float> line = costs.subspan(row * columns, columns);
        for (std::size_t j = 1; j < columns; ++j) {
            if (line[j] < line[best[row]]) {
                second[row] = best[row];
                best[row] = j;
            } else if (second[row] == columns || line[j] < line[second[row]]) {
                second[row] = j;
            }
        }
    }
    if (best[0] == best[1]) {
        const float keep_first = costs[best[0]] + costs[columns + second[1]];
        const float keep_second = costs[second[0]] + costs[columns + best[1]];
        if (keep_first <= keep_second) {
            best[1] = second[1];
        } else {
            best[0] = second[0];
        }
    }
    column_of_row_[0] = static_cast<std::uint32_t>(best[0]);
    column_of_row_[1] = static_cast<std::uint32_t>(best[1]);
}

}  // namespace ossuary::matching
