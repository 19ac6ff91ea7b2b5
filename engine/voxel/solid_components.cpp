#include "engine/voxel/solid_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/mesh/disjoint_sets.h"
#include "engine/voxel/border.h"
#include "engine/voxel/components.h"
#include "engine/voxel/count_components.h"

namespace ossuary {
namespace {

/// A possible bridge; ordered by length, then by place.
struct Bridge {
    int squared_length;
    Vec3i a, b;
    [[nodiscard]] auto key() const {
        return std::tuple(squared_length, a.z(), a.y(), a.x(), b.z(), b.y(), b.x());
    }
};

std::vector<Vec3i> offsets_within(int gap) {
    const int reach = gap + 1;
    std::vector<Vec3i> offsets;
    for (int z = -reach; z <= reach; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                if (Vec3i(x, y, z).cwiseAbs().maxCoeff() > 1) offsets.emplace_back(x, y, z);
            }
        }
    }
    return offsets;
}

/// Finds the component of a voxel among the runs by bisection.
class ComponentOf {
public:
    ComponentOf(const Components& components, const BitVolume& volume)
        : components_(components), rows_(static_cast<std::size_t>(volume.size().y())) {
        begin_.assign(rows_ * static_cast<std::size_t>(volume.size().z()) + 1, 0);
        for (const VoxelRun& run : components.runs) ++begin_[row(run.y, run.z) + 1];
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    }
    /// @pre the voxel is set
    [[nodiscard]] std::uint32_t operator()(const Vec3i& v) const {
        const std::size_t r = row(v.y(), v.z());
        const auto first = components_.runs.begin() + static_cast<std::ptrdiff_t>(begin_[r]);
        const auto last = components_.runs.begin() + static_cast<std::ptrdiff_t>(begin_[r + 1]);
        const auto after = std::upper_bound(
            first, last, v.x(), [](int x, const VoxelRun& run) { return x < run.begin; });
        return std::prev(after)->component;
    }

private:
    [[nodiscard]] std::size_t row(int y, int z) const {
        return static_cast<std::size_t>(z) * rows_ + static_cast<std::size_t>(y);
    }
    const Components& components_;
    std::size_t rows_;
    std::vector<std::size_t> begin_;
};

/// The shortest bridge between every two components that are near enough.
std::vector<Bridge> find_bridges(const BitVolume& volume, const Components& components, int gap) {
    const ComponentOf component_of(components, volume);
    const std::vector<Vec3i> offsets = offsets_within(gap);
    const auto largest = static_cast<std::uint32_t>(
        std::max_element(components.voxel_counts.begin(), components.voxel_counts.end()) -
        components.voxel_counts.begin());
    std::map<std::pair<std::uint32_t, std::uint32_t>, Bridge> best;
    // Looking out from all but the largest component finds every pair.
    BitVolume others(volume.size());
    for (const VoxelRun& run : components.runs) {
        if (run.component != largest) set_run(others, run);
    }
    for_each_voxel(border(others), [&](const Vec3i& a) {
        const std::uint32_t from = component_of(a);
        for (const Vec3i& offset : offsets) {
            const Vec3i b = a + offset;
            if (!volume.test_or_false(b)) continue;
            const std::uint32_t to = component_of(b);
            if (to == from) continue;
            const bool in_order = std::tuple(a.z(), a.y(), a.x()) < std::tuple(b.z(), b.y(), b.x());
            const Bridge bridge{offset.squaredNorm(), in_order ? a : b, in_order ? b : a};
            const auto [place, added] = best.try_emplace(std::minmax(from, to), bridge);
            if (!added && bridge.key() < place->second.key()) place->second = bridge;
        }
    });
    std::vector<Bridge> bridges;
    for (const auto& [pair, bridge] : best) bridges.push_back(bridge);
    std::sort(bridges.begin(), bridges.end(),
              [](const Bridge& a, const Bridge& b) { return a.key() < b.key(); });
    return bridges;
}

void draw_line(const Vec3i& a, const Vec3i& b, BitVolume& volume) {
    const int steps = (b - a).cwiseAbs().maxCoeff();
    for (int s = 0; s <= steps; ++s) {
        const Eigen::Vector3d at = a.cast<double>() + (b - a).cast<double>() * s / steps;
        volume.set(at.array().round().cast<int>());
    }
}

std::size_t build_bridges(BitVolume& volume, const Components& components, int gap) {
    const ComponentOf component_of(components, volume);
    DisjointSets joined(components.count());
    std::size_t built = 0;
    std::vector<Bridge> chosen;
    for (const Bridge& bridge : find_bridges(volume, components, gap)) {
        const std::uint32_t a = component_of(bridge.a);
        const std::uint32_t b = component_of(bridge.b);
        if (joined.find(a) == joined.find(b)) continue;
        joined.unite(a, b);
        chosen.push_back(bridge);
        ++built;
    }
    for (const Bridge& bridge : chosen) draw_line(bridge.a, bridge.b, volume);
    return built;
}

/// Removes the components that are small beside the largest one.
void drop_small(BitVolume& volume, double min_extent, JoinedComponents& result) {
    const Components components = label_components(volume, Connectivity::kVertices);
    result.remaining = components.count();
    if (components.count() < 2) return;
    std::vector<Vec3i> low(components.count(), volume.size());
    std::vector<Vec3i> high(components.count(), Vec3i::Zero());
    for (const VoxelRun& run : components.runs) {
        low[run.component] = low[run.component].cwiseMin(Vec3i(run.begin, run.y, run.z));
        high[run.component] = high[run.component].cwiseMax(Vec3i(run.end, run.y + 1, run.z + 1));
    }
    const auto extent = [&](std::uint32_t c) { return (high[c] - low[c]).maxCoeff(); };
    int longest = 0;
    for (std::uint32_t c = 0; c < components.count(); ++c) longest = std::max(longest, extent(c));
    for (const VoxelRun& run : components.runs) {
        if (extent(run.component) >= min_extent * longest) continue;
        reset_run(volume, run);
        result.dropped_voxels += static_cast<std::size_t>(run.end - run.begin);
    }
    for (std::uint32_t c = 0; c < components.count(); ++c) {
        if (extent(c) < min_extent * longest) ++result.dropped;
    }
    result.remaining -= result.dropped;
}

}  // namespace

JoinedComponents join_components(BitVolume& volume, const JoinOptions& options) {
    JoinedComponents result;
    result.remaining = count_components(volume);
    if (result.remaining < 2) return result;
    const Components components = label_components(volume, Connectivity::kVertices);
    if (options.bridge_gap > 0) {
        result.bridged = build_bridges(volume, components, options.bridge_gap);
    }
    drop_small(volume, options.min_component_extent, result);
    return result;
}

}  // namespace ossuary
