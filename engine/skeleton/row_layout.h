#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// Places for values of a set's voxels and of all their neighbours, row by row without the rest of
/// the grid: what belongs to a thin set lies close together in memory. The neighbours at dx = -1, 0
/// and 1 in one row have three places in turn, and one more place follows.
class RowLayout {
public:
    explicit RowLayout(const ThinningGrid& set)
        : row_(set.shape().row()),
          reciprocal_(std::numeric_limits<std::uint64_t>::max() / row_ + 1) {
        const std::size_t rows = set.shape().count() / row_;
        rows_in_plane_ = set.shape().plane() / row_;
        for (std::size_t i = 0; i < row_steps_.size(); ++i) {
            const auto k = static_cast<std::int32_t>(i);
            row_steps_[i] = (k / 3 - 1) * static_cast<std::int32_t>(rows_in_plane_) + k % 3 - 1;
        }
        struct Span {
            VoxelIndex begin = std::numeric_limits<VoxelIndex>::max();
            VoxelIndex end = 0;
        };
        std::vector<Span> spans(rows);  // by offset within the row, neighbours included
        const auto widen = [&](std::uint32_t row, VoxelIndex first, VoxelIndex last) {
            for (const std::int32_t step : row_steps_) {
                Span& span = spans[row + static_cast<std::uint32_t>(step)];
                span.begin = std::min(span.begin, first - 1);
                span.end = std::max(span.end, last + 2);
            }
        };
        std::uint32_t row = 0;
        VoxelIndex first = 0, last = 0, row_end = 0;
        set.for_each([&](VoxelIndex v) {
            if (v >= row_end) {
                if (row_end > 0) widen(row, first, last);
                row = row_of(v);
                row_end = (row + 1) * row_;
                first = v - row * row_;
            }
            last = v - row * row_;
        });
        if (row_end > 0) widen(row, first, last);
        starts_.resize(rows, 0);
        for (std::size_t r = 0; r < rows; ++r) {
            if (spans[r].end == 0) continue;
            starts_[r] =
                static_cast<std::int32_t>(count_) - static_cast<std::int32_t>(spans[r].begin);
            count_ += spans[r].end - spans[r].begin;
        }
        ++count_;
    }

    [[nodiscard]] std::size_t count() const { return count_; }
    /// v / row, as a product: exact, since v times row is below 2^64.
    [[nodiscard]] std::uint32_t row_of(VoxelIndex v) const {
        __extension__ using Product = unsigned __int128;
        return static_cast<std::uint32_t>(static_cast<Product>(v) * reciprocal_ >> 64);
    }
    [[nodiscard]] std::uint32_t offset_in_row(VoxelIndex v, std::uint32_t row) const {
        return v - row * row_;
    }
    /// @pre the voxel with this offset is in the set or beside one that is
    [[nodiscard]] std::size_t place(std::uint32_t offset, std::uint32_t row) const {
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(offset) + starts_[row]);
    }
    [[nodiscard]] std::size_t place(VoxelIndex v) const {
        const std::uint32_t row = row_of(v);
        return place(offset_in_row(v, row), row);
    }
    /// From a row to the nine around it, in the order of a neighbourhood's bits.
    [[nodiscard]] const std::array<std::int32_t, 9>& row_steps() const { return row_steps_; }

private:
    std::uint32_t row_;
    std::uint64_t reciprocal_;  ///< 2^64 / row, rounded up
    std::uint32_t rows_in_plane_ = 0;
    std::array<std::int32_t, 9> row_steps_{};
    std::size_t count_ = 0;
    std::vector<std::int32_t> starts_;  ///< what to add to an offset, by row
};

/// Where the neighbours of one voxel have their places: nine rows of three in turn.
class NeighborPlaces {
public:
    NeighborPlaces(const RowLayout& layout, VoxelIndex v) {
        const std::uint32_t row = layout.row_of(v);
        const std::uint32_t offset = layout.offset_in_row(v, row);
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const auto step = static_cast<std::uint32_t>(layout.row_steps()[r]);
            rows_[r] = layout.place(offset, row + step) - 1;
        }
    }

    /// Of the neighbour at dx = -1 in a row. @param r  0 to 8, in the order of a neighbourhood
    [[nodiscard]] std::size_t row(std::size_t r) const { return rows_[r]; }
    [[nodiscard]] std::size_t of(std::size_t bit) const { return rows_[bit / 3] + bit % 3; }
    [[nodiscard]] std::size_t centre() const { return rows_[4] + 1; }

private:
    std::array<std::size_t, 9> rows_;
};

}  // namespace ossuary::skeleton
