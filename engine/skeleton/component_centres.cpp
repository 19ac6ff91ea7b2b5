#include "engine/skeleton/component_centres.h"

#include <algorithm>
#include <limits>

#include "engine/voxel/components.h"

namespace ossuary::skeleton {

std::vector<ComponentCentre> component_centres(const voxel::BitVolume& solid,
                                               const voxel::DistanceField& distance) {
    const voxel::Components components =
        voxel::label_components(solid, voxel::Connectivity::kVertices);
    std::vector<ComponentCentre> centres(components.count());
    // Sums of whole numbers: exact, so the same in any order of summation.
    std::vector<Vec3> gravity(components.count(), Vec3::Zero());
    const auto squared_row = [&](const voxel::VoxelRun& run) {
        return distance.squared_row(run.y, run.z);
    };
    std::vector<std::uint32_t> deepest_of_run;
    deepest_of_run.reserve(components.runs.size());
    for (const voxel::VoxelRun& run : components.runs) {
        ComponentCentre& centre = centres[run.component];
        const std::uint32_t* row = squared_row(run);
        std::uint32_t deepest = 0;
        for (int x = run.begin; x < run.end; ++x) deepest = std::max(deepest, row[x]);
        deepest_of_run.push_back(deepest);
        centre.squared_radius = std::max(centre.squared_radius, deepest);
        const double length = run.end - run.begin;
        gravity[run.component] += length * Vec3(0.5 * (run.begin + run.end - 1), run.y, run.z);
    }
    for (std::size_t i = 0; i < centres.size(); ++i) {
        gravity[i] /= static_cast<double>(components.voxel_counts[i]);
    }
    const PaddedShape shape(solid.size());
    std::vector<double> nearest(centres.size(), std::numeric_limits<double>::infinity());
    for (std::size_t r = 0; r < components.runs.size(); ++r) {
        const voxel::VoxelRun& run = components.runs[r];
        const std::uint32_t* row = squared_row(run);
        const std::size_t i = run.component;
        if (deepest_of_run[r] != centres[i].squared_radius) continue;
        for (int x = run.begin; x < run.end; ++x) {
            if (row[x] != centres[i].squared_radius) continue;
            const double d = (Vec3(x, run.y, run.z) - gravity[i]).squaredNorm();
            if (d < nearest[i]) {
                nearest[i] = d;
                centres[i].voxel = shape.index(x, run.y, run.z);
            }
        }
    }
    return centres;
}

}  // namespace ossuary::skeleton
