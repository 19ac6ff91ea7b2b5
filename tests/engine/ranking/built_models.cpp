#include "tests/engine/ranking/built_models.h"

#include <cmath>

#include "engine/descriptor/body_scale.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/signature.h"
#include "engine/descriptor/solid_surface.h"
#include "engine/matching/skeleton_descriptor.h"
#include "engine/skeleton/tube_radii.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

Vec3 random_direction(std::mt19937_64& random) {
    for (;;) {
        const Vec3 v(2.0 * next_unit(random) - 1.0, 2.0 * next_unit(random) - 1.0,
                     2.0 * next_unit(random) - 1.0);
        if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
}

std::vector<Capsule> limbs(std::uint64_t family, std::uint64_t seed) {
    std::mt19937_64 build(family * 7919 + 17), change(family * 7919 + seed * 104729 + 3);
    const Vec3 other_end(8.0 + 12.0 * next_unit(build), 0.0, 0.0);
    std::vector<Capsule> capsules = {{Vec3::Zero(), other_end, 3.0 + 3.0 * next_unit(build)}};
    const std::size_t count = 3 + next_below(build, 4);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 root = i % 2 == 0 ? Vec3::Zero().eval() : other_end;
        const double length = (8.0 + 14.0 * next_unit(build)) * (0.9 + 0.2 * next_unit(change));
        const Vec3 direction =
            (random_direction(build) + 0.15 * random_direction(change)).normalized();
        const double radius = (1.3 + 2.0 * next_unit(build)) * (0.9 + 0.2 * next_unit(change));
        capsules.push_back({root, root + length * direction, radius});
    }
    return capsules;
}

double distance_to(const Capsule& capsule, const Vec3& p) {
    const Vec3 axis = capsule.b - capsule.a;
    const double t = std::clamp((p - capsule.a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    return (p - capsule.a - t * axis).norm();
}

skeleton::SkeletonGraph skeleton_of(const std::vector<Capsule>& capsules) {
    skeleton::SkeletonGraph graph;
    const auto node_at = [&](const Vec3& position, double radius) {
        for (std::uint32_t i = 0; i < graph.nodes.size(); ++i) {
            if (graph.nodes[i].position == position) return i;
        }
        graph.nodes.push_back({position, radius, 0.0, 0});
        return static_cast<std::uint32_t>(graph.nodes.size() - 1);
    };
    for (const Capsule& capsule : capsules) {
        skeleton::SkeletonGraph::Branch branch;
        branch.a = node_at(capsule.a, capsule.radius);
        branch.b = node_at(capsule.b, capsule.radius);
        const int steps = std::max(2, static_cast<int>((capsule.b - capsule.a).norm()));
        for (int i = 0; i <= steps; ++i) {
            branch.points.push_back(capsule.a +
                                    (static_cast<double>(i) / steps) * (capsule.b - capsule.a));
            branch.radii.push_back(capsule.radius);
        }
        graph.nodes[branch.a].significance += branch.length();
        graph.nodes[branch.b].significance += branch.length();
        graph.branches.push_back(std::move(branch));
    }
    skeleton::update_degrees(graph);
    return graph;
}

}  // namespace

descriptor::ModelDescriptor built_model(std::uint64_t family, std::uint64_t seed) {
    const std::vector<Capsule> capsules = limbs(family, seed);
    Box3 bounds;
    for (const Capsule& capsule : capsules) {
        const Vec3 reach = Vec3::Constant(capsule.radius);
        bounds.extend(Box3(capsule.a - reach, capsule.a + reach));
        bounds.extend(Box3(capsule.b - reach, capsule.b + reach));
    }
    const voxel::BitVolume volume = sample_volume(bounds, [&](const Vec3& p) {
        for (const Capsule& capsule : capsules) {
            if (distance_to(capsule, p) <= capsule.radius) return true;
        }
        return false;
    });
    const descriptor::SolidSurface surface = descriptor::solid_surface(volume);
    const auto voxels = static_cast<double>(volume.count());
    const double scale = descriptor::body_scale(surface.total_area, voxels);
    descriptor::ModelDescriptor model;
    const skeleton::SkeletonGraph graph = skeleton_of(capsules);
    model.skeleton = matching::describe_skeleton(graph, scale);
    model.skeleton.solid_volume = static_cast<float>(voxels / (scale * scale * scale));
    model.skeleton.limb_volume =
        static_cast<float>(skeleton::tube_volume(graph) / (scale * scale * scale));
    model.globals = descriptor::global_descriptors(surface, volume, {&model.skeleton, 1});
    model.signature = descriptor::preselection_signature(model.skeleton, model.globals);
    return model;
}

std::vector<descriptor::ModelDescriptor> built_collection(std::size_t families,
                                                          std::size_t members) {
    std::vector<descriptor::ModelDescriptor> models;
    for (std::size_t family = 0; family < families; ++family) {
        for (std::size_t seed = 0; seed < members; ++seed) {
            models.push_back(built_model(family, seed));
        }
    }
    return models;
}

std::vector<const descriptor::ModelDescriptor*> pointers(
    const std::vector<descriptor::ModelDescriptor>& models) {
    std::vector<const descriptor::ModelDescriptor*> result;
    for (const descriptor::ModelDescriptor& model : models) result.push_back(&model);
    return result;
}

}  // namespace ossuary::test
