#include "engine/voxel/components.h"

#include <algorithm>

#include "engine/mesh/disjoint_sets.h"
#include "engine/voxel/inner_runs.h"

namespace ossuary::voxel {
namespace {

/// Unites the runs of two rows that touch; `reach` is 0 when faces count and 1 when corners do.
void unite_rows(const std::vector<VoxelRun>& runs, std::size_t a, std::size_t a_end, std::size_t b,
                std::size_t b_end, int reach, mesh::DisjointSets& sets) {
    while (a < a_end && b < b_end) {
        if (runs[a].begin < runs[b].end + reach && runs[b].begin < runs[a].end + reach) {
            sets.unite(runs[a].component, runs[b].component);
        }
        if (runs[a].end < runs[b].end) {
            ++a;
        } else {
            ++b;
        }
    }
}

bool is_empty(std::span<const std::uint64_t> row) {
    std::uint64_t any = 0;
    for (const std::uint64_t word : row) any |= word;
    return any == 0;
}

/// @param outside  label runs of the background, with the beyond as component 0
Components label(const BitVolume& volume, Connectivity connectivity, bool outside) {
    const Vec3i size = volume.size();
    const int reach = connectivity == Connectivity::kVertices ? 1 : 0;
    Components result;
    mesh::DisjointSets sets(0);
    if (outside) sets.add();
    std::vector<std::size_t> row_begin;
    const auto row_of = [&](int y, int z) {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y()) +
               static_cast<std::size_t>(y);
    };
    row_begin.reserve(row_of(0, size.z()) + 1);
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            const std::size_t first = result.runs.size();
            row_begin.push_back(first);
            if (!outside && is_empty(volume.row(y, z))) continue;
            const bool border_row = y == 0 || z == 0 || y + 1 == size.y() || z + 1 == size.z();
            for_each_run(volume.row(y, z), size.x(), outside, [&](int begin, int end) {
                result.runs.push_back({begin, end, y, z, sets.add()});
                if (outside && (border_row || begin == 0 || end == size.x())) {
                    sets.unite(0, result.runs.back().component);
                }
            });
            const std::size_t last = result.runs.size();
            const auto unite_with = [&](int other_y, int other_z) {
                const std::size_t row = row_of(other_y, other_z);
                unite_rows(result.runs, first, last, row_begin[row],
                           row + 1 < row_begin.size() ? row_begin[row + 1] : first, reach, sets);
            };
            if (first == last) continue;
            if (y > 0) unite_with(y - 1, z);
            if (z > 0) {
                unite_with(y, z - 1);
                if (reach > 0 && y > 0) unite_with(y - 1, z - 1);
                if (reach > 0 && y + 1 < size.y()) unite_with(y + 1, z - 1);
            }
        }
    }
    // Roots come before what they unite, so one pass numbers the components by first appearance.
    std::vector<std::uint32_t> number(result.runs.size() + (outside ? 1 : 0));
    if (outside) result.voxel_counts.push_back(0);
    for (VoxelRun& run : result.runs) {
        const std::uint32_t root = sets.find(run.component);
        if (root == run.component) {
            number[root] = static_cast<std::uint32_t>(result.voxel_counts.size());
            result.voxel_counts.push_back(0);
        }
        run.component = number[root];
        result.voxel_counts[run.component] += static_cast<std::size_t>(run.end - run.begin);
    }
    return result;
}

/// Calls change(word, mask) for the words that the run touches.
template <typename Change>
void for_each_word(BitVolume& volume, const VoxelRun& run, Change&& change) {
    const auto row = volume.row(run.y, run.z);
    for (int x = run.begin; x < run.end;) {
        const int word = x >> 6;
        const int bits = std::min(run.end, (word + 1) << 6) - x;
        const std::uint64_t ones = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
        change(row[static_cast<std::size_t>(word)], ones << (x & 63));
        x += bits;
    }
}

}  // namespace

Components label_components(const BitVolume& volume, Connectivity connectivity) {
    return label(volume, connectivity, false);
}

Components label_background(const BitVolume& volume) {
    return label(volume, Connectivity::kFaces, true);
}

void set_run(BitVolume& volume, const VoxelRun& run) {
    for_each_word(volume, run, [](std::uint64_t& word, std::uint64_t mask) { word |= mask; });
}

void reset_run(BitVolume& volume, const VoxelRun& run) {
    for_each_word(volume, run, [](std::uint64_t& word, std::uint64_t mask) { word &= ~mask; });
}

FilledCavities fill_cavities(BitVolume& volume) {
    FilledCavities filled;
    filled.cavities = count_cavities(volume);
    if (filled.cavities == 0) return filled;
    const Components background = label_background(volume);
    for (const VoxelRun& run : background.runs) {
        if (run.component == 0) continue;
        set_run(volume, run);
        filled.voxels += static_cast<std::size_t>(run.end - run.begin);
    }
    return filled;
}

}  // namespace ossuary::voxel
