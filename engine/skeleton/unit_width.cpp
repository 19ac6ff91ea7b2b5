#include "engine/skeleton/unit_width.h"

#include <algorithm>
#include <cmath>

#include "engine/core/geometry.h"
#include "engine/skeleton/simple_point.h"

namespace ossuary::skeleton {
namespace {

bool is_removable(const SimplePointTest& is_simple, Neighborhood around) {
    return std::popcount(around & k26Neighbors) >= 2 && is_simple(around);
}

struct CrowdVoxel {
    VoxelIndex voxel = 0;
    int valence = 0;
    long long spread = 0;  ///< sum of distances to the rest of the crowd, rounded to 1/1024
    Vec3i position = Vec3i::Zero();
};

/// The 26-component of `members` that holds `seed`; its voxels leave `members`.
std::vector<CrowdVoxel> take_crowd(VoxelIndex seed, ThinningGrid& members,
                                   const ThinningGrid& object) {
    const PaddedShape& shape = object.shape();
    const auto steps = shape.neighbor_steps();
    std::vector<CrowdVoxel> crowd;
    members.reset(seed);
    crowd.push_back({seed, 0, 0, shape.position(seed)});
    for (std::size_t i = 0; i < crowd.size(); ++i) {
        const VoxelIndex v = crowd[i].voxel;
        crowd[i].valence = std::popcount(object.neighborhood(v) & k26Neighbors);
        for_each_bit(members.neighborhood(v), [&](int bit) {
            const VoxelIndex n = moved(v, steps[static_cast<std::size_t>(bit)]);
            members.reset(n);
            crowd.push_back({n, 0, 0, shape.position(n)});
        });
    }
    return crowd;
}

/// Distances to all others up to this many voxels, to the centre of gravity beyond.
constexpr std::size_t kLargestCrowdWithMedian = 256;

void measure_spread(std::vector<CrowdVoxel>& crowd) {
    constexpr double kScale = 1024.0;
    if (crowd.size() <= kLargestCrowdWithMedian) {
        for (CrowdVoxel& a : crowd) {
            for (const CrowdVoxel& b : crowd) {
                a.spread += std::llround(kScale * (a.position - b.position).cast<double>().norm());
            }
        }
        return;
    }
    Vec3 centre = Vec3::Zero();
    for (const CrowdVoxel& a : crowd) centre += a.position.cast<double>();
    centre /= static_cast<double>(crowd.size());
    for (CrowdVoxel& a : crowd) {
        a.spread = std::llround(kScale * (a.position.cast<double>() - centre).norm());
    }
}

}  // namespace

void thin_to_unit_width(ThinningGrid& object, const std::stop_token& stop) {
    const SimplePointTest& is_simple = SimplePointTest::shared();
    const auto steps = object.shape().neighbor_steps();
    std::vector<VoxelIndex> suspects;
    object.for_each([&](VoxelIndex v) { suspects.push_back(v); });
    ThinningGrid members(object.shape());
    while (!suspects.empty()) {
        std::vector<VoxelIndex> seeds;
        for (const VoxelIndex v : suspects) {
            if (object.test(v) && !members.test(v) &&
                is_removable(is_simple, object.neighborhood(v))) {
                members.set(v);
                seeds.push_back(v);
            }
        }
        suspects.clear();
        for (const VoxelIndex seed : seeds) {
            if (stop.stop_requested()) return;
            if (!members.test(seed)) continue;
            std::vector<CrowdVoxel> crowd = take_crowd(seed, members, object);
            measure_spread(crowd);
            std::sort(crowd.begin(), crowd.end(), [](const CrowdVoxel& a, const CrowdVoxel& b) {
                if (a.spread != b.spread) return a.spread > b.spread;
                if (a.valence != b.valence) return a.valence < b.valence;
                return a.voxel < b.voxel;
            });
            for (const CrowdVoxel& c : crowd) {
                const Neighborhood around = object.neighborhood(c.voxel);
                if (!is_removable(is_simple, around)) continue;
                object.reset(c.voxel);
                for_each_bit(around & k26Neighbors, [&](int bit) {
                    suspects.push_back(moved(c.voxel, steps[static_cast<std::size_t>(bit)]));
                });
            }
        }
    }
}

}  // namespace ossuary::skeleton
