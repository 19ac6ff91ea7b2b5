#include "engine/decomposition/pair_features.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/decomposition/patch_paths.h"
#include "engine/decomposition/skeleton_anchors.h"
#include "engine/descriptor/shape_diameter.h"

namespace ossuary::decomposition {

namespace {

constexpr std::size_t kSamplesPerPatch = 5;

/// One number a patch, on the logarithmic or linear scale that the features use.
struct PatchMeasures {
    std::vector<double> thickness;  ///< log of shape diameter over scale
    std::vector<double> centrality;
    std::vector<double> radius;  ///< log of the skeleton's radius over scale
    std::vector<double> reach;
    std::vector<std::uint32_t> sample;  ///< of the skeleton
    std::vector<std::int32_t> branch;
};

/// Everything in voxels of the solid's grid, where lines are cast.
struct GridPatches {
    std::vector<Vec3> center;
    std::vector<Vec3> normal;
    std::vector<Vec3> middle;  ///< half a shape diameter inside
    std::vector<Vec3> near;    ///< just inside
};

/// The shape diameters of a few triangles of each patch, in voxels; the median for each patch.
std::vector<double> median_diameters(const SurfaceGraph& surface, const PatchGraph& graph,
                                     const voxel::VoxelSolid& solid) {
    std::vector<std::vector<std::uint32_t>> triangles(graph.size());
    for (std::size_t p = 0; p < graph.size(); ++p) triangles[p].reserve(graph.patches[p].triangles);
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        if (!surface.normals[t].isZero()) triangles[graph.of_triangle[t]].push_back(t);
    }
    descriptor::ShellGraph points;
    std::vector<std::size_t> owner;
    const Mat3 to_grid = solid.world_from_grid.rotation.transpose();
    for (std::size_t p = 0; p < graph.size(); ++p) {
        const std::size_t wanted = std::min(kSamplesPerPatch, triangles[p].size());
        for (std::size_t k = 0; k < wanted; ++k) {
            const std::uint32_t t = triangles[p][(2 * k + 1) * triangles[p].size() / (2 * wanted)];
            points.points.push_back(solid.world_from_grid.grid(surface.centers[t]).cast<float>());
            points.normals.push_back((to_grid * surface.normals[t]).cast<float>());
            owner.push_back(p);
        }
    }
    const std::vector<float> diameters = descriptor::shape_diameters(points, solid.volume);
    std::vector<std::vector<float>> found(graph.size());
    for (std::size_t i = 0; i < owner.size(); ++i) found[owner[i]].push_back(diameters[i]);
    std::vector<double> median(graph.size(), 1.0);
    for (std::size_t p = 0; p < graph.size(); ++p) {
        if (found[p].empty()) continue;
        std::sort(found[p].begin(), found[p].end());
        median[p] = static_cast<double>(found[p][found[p].size() / 2]);
    }
    return median;
}

/// Averages each patch with those around it that are about as thick.
std::vector<double> smoothed(const PatchGraph& graph, const std::vector<double>& thickness) {
    std::vector<double> result(graph.size());
    for (std::size_t p = 0; p < graph.size(); ++p) {
        double weight = graph.patches[p].area + 1e-300, sum = weight * thickness[p];
        for (const PatchGraph::Link& link : graph.links[p]) {
            const double difference = std::abs(thickness[p] - thickness[link.to]);
            const double w = 0.5 * graph.patches[link.to].area * std::exp(-2.0 * difference);
            weight += w;
            sum += w * thickness[link.to];
        }
        result[p] = sum / weight;
    }
    return result;
}

GridPatches lay_into_grid(const PatchGraph& graph, const WorldFromGrid& world_from_grid,
                          const std::vector<double>& thickness, double scale_voxels) {
    GridPatches grid;
    for (std::size_t p = 0; p < graph.size(); ++p) {
        const Vec3 center = world_from_grid.grid(graph.patches[p].center);
        const Vec3 normal = world_from_grid.rotation.transpose() * graph.patches[p].normal;
        const double diameter = std::exp(thickness[p]) * scale_voxels;
        grid.center.push_back(center);
        grid.normal.push_back(normal);
        grid.middle.push_back(center - 0.5 * diameter * normal);
        grid.near.push_back(center - std::min(0.25 * diameter, 2.0) * normal);
    }
    return grid;
}

void find_anchors(const GridPatches& grid, const SkeletonSamples& samples,
                  const voxel::BitVolume& solid, double scale_voxels, PatchMeasures& measures) {
    for (std::size_t p = 0; p < grid.center.size(); ++p) {
        const SkeletonAnchor found =
            anchor(samples, solid, grid.center[p], grid.near[p], grid.normal[p]);
        const SkeletonSamples::Point& point = samples.points[found.sample];
        measures.sample.push_back(found.sample);
        measures.branch.push_back(point.branch);
        measures.radius.push_back(std::log(std::max(0.5, point.radius) / scale_voxels));
        measures.reach.push_back(found.excess / scale_voxels);
    }
}

double turn_between(const PatchGraph& graph, std::size_t p, std::size_t q) {
    const PatchGraph::Patch &a = graph.patches[p], &b = graph.patches[q];
    const bool concave = (b.center - a.center).dot(a.normal - b.normal) > 0.0;
    return concave ? std::acos(std::clamp(a.normal.dot(b.normal), -1.0, 1.0)) : 0.0;
}

double gap_between(const PatchGraph& graph, std::size_t p, std::size_t q) {
    return (graph.patches[p].center - graph.patches[q].center).norm();
}

/// Fills the features in; holds what several of them share.
class PairMeasuring {
public:
    PairMeasuring(const PatchGraph& graph, const PatchMeasures& measures, double scale)
        : graph_(graph), measures_(measures), scale_(scale) {
        pairs_.patches = graph.size();
        pairs_.features.resize(graph.size() * (graph.size() - 1) / 2);
        pairs_.branch_of_patch = measures.branch;
    }

    void along_the_surface(const PatchTable& geodesic) {
        const PatchTable concave = least_sums(graph_, [&](std::size_t p, const auto& link) {
            return turn_between(graph_, p, link.to) +
                   0.02 * gap_between(graph_, p, link.to) / scale_;
        });
        const PatchTable barrier = least_barriers(graph_, [&](std::size_t p, const auto& link) {
            return turn_between(graph_, p, link.to);
        });
        const PatchTable crease =
            least_barriers(graph_, [](std::size_t, const auto& link) { return link.concavity; });
        each_pair([&](std::size_t i, std::size_t j, auto&& set) {
            const float straight = static_cast<float>(gap_between(graph_, i, j) / scale_);
            const float way = std::min(geodesic(i, j), 6.0F), bend = std::min(concave(i, j), 12.0F);
            set(PairFeature::kDistance, std::log1p(straight));
            set(PairFeature::kGeodesic, std::log1p(way));
            set(PairFeature::kDetour, std::log((way + 0.05F) / (straight + 0.05F)));
            set(PairFeature::kConcaveWay, std::log1p(bend));
            set(PairFeature::kConcaveDensity, bend / (way + 0.3F));
            set(PairFeature::kConcaveBarrier, barrier(i, j));
            set(PairFeature::kCreaseBarrier, crease(i, j));
            set_both(set, i, j, measures_.centrality, PairFeature::kCentralityLeast,
                     PairFeature::kCentralityMost);
            set(PairFeature::kNormals,
                static_cast<float>(graph_.patches[i].normal.dot(graph_.patches[j].normal)));
        });
    }

    void thickness() {
        const std::vector<double>& t = measures_.thickness;
        const PatchTable neck = least_barriers(
            graph_, [&](std::size_t p, const auto& link) { return -std::min(t[p], t[link.to]); });
        const PatchTable bulge = least_barriers(
            graph_, [&](std::size_t p, const auto& link) { return std::max(t[p], t[link.to]); });
        const PatchTable step = least_barriers(
            graph_, [&](std::size_t p, const auto& link) { return std::abs(t[p] - t[link.to]); });
        each_pair([&](std::size_t i, std::size_t j, auto&& set) {
            const auto [least, most] =
                std::minmax({static_cast<float>(t[i]), static_cast<float>(t[j])});
            set_both(set, i, j, t, PairFeature::kThicknessLeast, PairFeature::kThicknessMost);
            set(PairFeature::kThicknessNeck, std::clamp(least + neck(i, j), 0.0F, 4.0F));
            set(PairFeature::kThicknessBulge, std::clamp(bulge(i, j) - most, 0.0F, 4.0F));
            set(PairFeature::kThicknessStep, std::min(step(i, j), 4.0F));
        });
    }

    void resistance() {
        const auto plain = [&](std::size_t p, const PatchGraph::Link& link) {
            return 0.5 * link.border / std::max(gap_between(graph_, p, link.to), 1e-9 * scale_);
        };
        const auto creased = [&](std::size_t p, const PatchGraph::Link& link) {
            return plain(p, link) *
                   std::exp(-3.0 * link.concavity - 2.0 * turn_between(graph_, p, link.to));
        };
        const auto set_all = [&](const LinkCost& conductance, PairFeature whole, PairFeature far) {
            const Resistances found = resistances(graph_, conductance);
            each_pair([&](std::size_t i, std::size_t j, auto&& set) {
                set(whole, std::log1p(std::min(found.whole(i, j), 50.0F)));
                set(far, std::log1p(std::min(found.far(i, j), 50.0F)));
            });
        };
        set_all(plain, PairFeature::kResistance, PairFeature::kResistanceFar);
        set_all(creased, PairFeature::kCreaseResistance, PairFeature::kCreaseResistanceFar);
    }

    void through_the_solid(const GridPatches& grid, const voxel::BitVolume& solid,
                           double scale_voxels) {
        each_pair([&](std::size_t i, std::size_t j, auto&& set) {
            const Outside near = outside(solid, grid.near[i], grid.near[j]);
            set(PairFeature::kOutsideMiddle, outside(solid, grid.middle[i], grid.middle[j]).share);
            set(PairFeature::kOutsideNear, near.share);
            set(PairFeature::kOutsideLength,
                std::log1p(5.0F * near.length / static_cast<float>(scale_voxels)));
        });
    }

    void along_the_skeleton(const SkeletonSamples& samples, double scale_voxels) {
        std::vector<SkeletonWays> ways(samples.points.size());
        for (const std::uint32_t sample : measures_.sample) {
            if (ways[sample].length.empty()) ways[sample] = ways_from(samples, sample);
        }
        const auto radius = [&](std::uint32_t s) {
            return static_cast<float>(samples.points[s].radius);
        };
        each_pair([&](std::size_t i, std::size_t j, auto&& set) {
            const std::uint32_t a = measures_.sample[i], b = measures_.sample[j];
            const SkeletonWays& way = ways[a];
            const bool joined = std::isfinite(way.length[b]);
            const auto [small, large] = std::minmax({radius(a), radius(b)});
            set(PairFeature::kSkeletonWay,
                joined ? std::min(way.length[b] / static_cast<float>(scale_voxels), 5.0F) : 5.0F);
            set(PairFeature::kSkeletonNeck,
                joined ? std::log(std::max(0.2F, way.least_radius[b] / std::max(small, 0.5F)))
                       : std::log(0.2F));
            set(PairFeature::kSkeletonBulge,
                joined ? std::log(std::max(1.0F, way.largest_radius[b]) / std::max(large, 1.0F))
                       : 0.0F);
            set(PairFeature::kSkeletonJunctions, joined ? std::min(way.junctions[b], 5.0F) : 5.0F);
            set(PairFeature::kSameBranch, measures_.branch[i] == measures_.branch[j] ? 1.0F : 0.0F);
            set_both(set, i, j, measures_.radius, PairFeature::kRadiusLeast,
                     PairFeature::kRadiusMost);
            set_both(set, i, j, measures_.reach, PairFeature::kReachLeast, PairFeature::kReachMost);
        });
    }

    PatchPairs take() { return std::move(pairs_); }

private:
    template <typename Visit>
    void each_pair(Visit visit) {
        std::size_t index = 0;
        for (std::size_t j = 1; j < graph_.size(); ++j) {
            for (std::size_t i = 0; i < j; ++i) {
                PairFeatures& features = pairs_.features[index++];
                visit(i, j, [&](PairFeature feature, float value) {
                    features[static_cast<std::size_t>(feature)] = value;
                });
            }
        }
    }
    template <typename Set>
    static void set_both(Set&& set, std::size_t i, std::size_t j, const std::vector<double>& values,
                         PairFeature least, PairFeature most) {
        set(least, static_cast<float>(std::min(values[i], values[j])));
        set(most, static_cast<float>(std::max(values[i], values[j])));
    }

    const PatchGraph& graph_;
    const PatchMeasures& measures_;
    double scale_;
    PatchPairs pairs_;
};

std::vector<double> mean_distances(const PatchGraph& graph, const PatchTable& geodesic) {
    std::vector<double> means(graph.size(), 0.0);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        for (std::size_t j = 0; j < graph.size(); ++j) {
            means[i] += graph.patches[j].area * static_cast<double>(geodesic(i, j));
        }
        means[i] /= graph.total_area;
    }
    return means;
}

}  // namespace

PatchPairs pair_features(const SurfaceGraph& surface, const PatchGraph& graph,
                         const skeleton::Skeleton& skeleton, const std::stop_token& stop) {
    if (graph.size() < 2) {
        return {graph.size(), {}, std::vector<std::int32_t>(graph.size(), -1)};
    }
    const voxel::VoxelSolid& solid = skeleton.solid;
    const double scale = std::sqrt(graph.total_area);
    const double scale_voxels = scale / solid.world_from_grid.voxel_size;
    const PatchTable geodesic = least_sums(graph, [&](std::size_t p, const auto& link) {
        return gap_between(graph, p, link.to) / scale;
    });

    PatchMeasures measures;
    measures.thickness = median_diameters(surface, graph, solid);
    for (double& diameter : measures.thickness) diameter = std::log(diameter / scale_voxels);
    measures.thickness = smoothed(graph, measures.thickness);
    measures.centrality = mean_distances(graph, geodesic);
    const GridPatches grid =
        lay_into_grid(graph, solid.world_from_grid, measures.thickness, scale_voxels);
    const SkeletonSamples samples = sample_skeleton(skeleton.refined);
    find_anchors(grid, samples, solid.volume, scale_voxels, measures);

    PairMeasuring measuring(graph, measures, scale);
    const auto going_on = [&stop] { return !stop.stop_requested(); };
    if (going_on()) measuring.along_the_surface(geodesic);
    if (going_on()) measuring.thickness();
    if (going_on()) measuring.resistance();
    if (going_on()) measuring.through_the_solid(grid, solid.volume, scale_voxels);
    if (going_on()) measuring.along_the_skeleton(samples, scale_voxels);
    return measuring.take();
}

}  // namespace ossuary::decomposition
