#include "engine/voxel/inner_runs.h"

#include <bit>
#include <limits>
#include <vector>

#include "engine/mesh/disjoint_sets.h"

namespace ossuary::voxel {
namespace {

/// A stretch of background between two set voxels of a row.
struct InnerRun {
    std::int32_t begin, end;
};

/// The set voxels of a row are in [begin, end), and its inner runs are those from `first_run` on.
struct RowExtent {
    std::int32_t begin = std::numeric_limits<std::int32_t>::max();
    std::int32_t end = -1;
    std::uint32_t first_run = 0;
};

class InnerRuns {
public:
    explicit InnerRuns(const BitVolume& volume) : ny_(volume.size().y()), nz_(volume.size().z()) {
        extents_.resize(static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_) + 1);
        std::size_t row = 0;
        for (int z = 0; z < nz_; ++z) {
            for (int y = 0; y < ny_; ++y)
                add_row(volume.row(y, z), volume.size().x(), extents_[row++]);
        }
        extents_[row].first_run = static_cast<std::uint32_t>(runs_.size());
    }

    /// How many of the sets that inner runs form by touching with faces are closed on all sides.
    [[nodiscard]] std::size_t closed_sets() const {
        if (runs_.empty()) return 0;
        const auto outside = static_cast<std::uint32_t>(runs_.size());
        mesh::DisjointSets sets(runs_.size() + 1);
        std::size_t row = 0;
        for (int z = 0; z < nz_; ++z) {
            for (int y = 0; y < ny_; ++y, ++row) {
                const std::uint32_t end = extents_[row + 1].first_run;
                for (std::uint32_t r = extents_[row].first_run; r < end; ++r) {
                    if (y == 0 || z == 0 || y + 1 == ny_ || z + 1 == nz_) sets.unite(r, outside);
                    const auto plane = static_cast<std::size_t>(ny_);
                    if (y > 0) touch(r, row - 1, outside, sets);
                    if (z > 0) touch(r, row - plane, outside, sets);
                    if (y + 1 < ny_) touch_outside(r, row + 1, outside, sets);
                    if (z + 1 < nz_) touch_outside(r, row + plane, outside, sets);
                }
            }
        }
        std::size_t closed = 0;
        const std::uint32_t open = sets.find(outside);
        for (std::uint32_t r = 0; r < outside; ++r) {
            if (sets.find(r) == r && r != open) ++closed;
        }
        return closed;
    }

private:
    void add_row(std::span<const std::uint64_t> words, int size, RowExtent& extent) {
        extent.first_run = static_cast<std::uint32_t>(runs_.size());
        std::size_t first = 0, last = words.size();
        while (first < last && words[first] == 0) ++first;
        if (first == last) return;
        while (words[last - 1] == 0) --last;
        extent.begin = static_cast<std::int32_t>(64 * first) + std::countr_zero(words[first]);
        extent.end = static_cast<std::int32_t>(64 * last) - std::countl_zero(words[last - 1]);
        // Most rows are one run, and have no inner ones.
        int ones = 0;
        for (std::size_t w = first; w < last; ++w) ones += std::popcount(words[w]);
        if (ones == extent.end - extent.begin) return;
        std::int32_t begin_inner = -1;
        for_each_run(words, size, false, [&](int begin, int end) {
            if (begin_inner >= 0) runs_.push_back({begin_inner, begin});
            begin_inner = end;
        });
    }

    void touch_outside(std::uint32_t run, std::size_t other_row, std::uint32_t outside,
                       mesh::DisjointSets& sets) const {
        const InnerRun& r = runs_[run];
        const RowExtent& other = extents_[other_row];
        if (r.begin < other.begin || r.end > other.end) sets.unite(run, outside);
    }

    void touch(std::uint32_t run, std::size_t other_row, std::uint32_t outside,
               mesh::DisjointSets& sets) const {
        touch_outside(run, other_row, outside, sets);
        const InnerRun& r = runs_[run];
        const std::uint32_t end = extents_[other_row + 1].first_run;
        for (std::uint32_t o = extents_[other_row].first_run; o < end; ++o) {
            if (r.begin < runs_[o].end && runs_[o].begin < r.end) sets.unite(run, o);
        }
    }

    int ny_, nz_;
    std::vector<InnerRun> runs_;
    std::vector<RowExtent> extents_;  ///< and one more, where the runs end
};

}  // namespace

std::size_t count_cavities(const BitVolume& volume) { return InnerRuns(volume).closed_sets(); }

}  // namespace ossuary::voxel
