#pragma once

#include <random>
#include <vector>

#include "engine/matching/skeleton_descriptor.h"
#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::test {

/// Builds skeleton graphs in voxel units.
class SkeletonBuilder {
public:
    std::uint32_t node(const Vec3& position, double radius);
    /// A branch from a to b that bulges by `bulge` at its middle, with radii between the nodes'.
    std::uint32_t branch(std::uint32_t a, std::uint32_t b, const Vec3& bulge = Vec3::Zero());
    /// The graph with degrees, and significances as the branch lengths and radii of each node.
    [[nodiscard]] skeleton::SkeletonGraph graph() const;

private:
    skeleton::SkeletonGraph graph_;
};

/// Trunk, head, two arms and two legs; `pose` in [0, 1] raises the arms and parts the legs.
skeleton::SkeletonGraph human(double pose);
/// Trunk, neck with head, tail and four legs; `pose` in [0, 1] swings the legs and lifts the head.
skeleton::SkeletonGraph four_leg(double pose);
/// Eight curved arms from one junction.
skeleton::SkeletonGraph octopus(double pose);
skeleton::SkeletonGraph point();
skeleton::SkeletonGraph curve();
skeleton::SkeletonGraph ring();
skeleton::SkeletonGraph cup();           ///< a stem with a handle
skeleton::SkeletonGraph figure_eight();  ///< two loops through one node
skeleton::SkeletonGraph two_components();

/// A random tree with `extra` further branches that close cycles.
skeleton::SkeletonGraph random_skeleton(std::mt19937& random, int nodes, int extra);

/// The same skeleton with nodes and branches in another order and some branches reversed.
skeleton::SkeletonGraph renumbered(const skeleton::SkeletonGraph& graph, std::mt19937& random);
skeleton::SkeletonGraph moved(const skeleton::SkeletonGraph& graph, const Mat3& linear,
                              const Vec3& shift, double scale);

/// All of these and twenty random ones, some with cycles, as descriptors.
std::vector<matching::SkeletonDescriptor> many_skeletons(std::uint32_t seed);

/// Descriptor at a scale that suits the built skeletons.
matching::SkeletonDescriptor describe(const skeleton::SkeletonGraph& graph, double scale = 100.0);

}  // namespace ossuary::test
