#pragma once

#include <stop_token>

#include "engine/skeleton/skeleton_graph.h"
#include "engine/voxel/bit_volume.h"
#include "engine/voxel/distance_transform.h"

namespace ossuary::skeleton {

/// The graph of a skeleton of unit width (thesis sec. 3.2.2), in voxels of the grid: a voxel's
/// centre is at its index plus one half, radii are distances to the nearest background centre.
///
/// Voxels with one neighbour are end nodes, those with more than two junctions; junction voxels
/// that touch become one node at their centre of gravity with their largest radius. Chains of
/// voxels with two neighbours are branches. A closed curve without a junction gets one node of
/// degree 2 at its deepest voxel, an isolated voxel one of degree 0. Where the skeleton is a set of
/// curves, the graph has as many cycles as the skeleton has tunnels; a closed surface, which
/// thinning keeps around a cavity, is drawn together into a few nodes instead. Not complete when
/// stopped.
SkeletonGraph extract_graph(const voxel::BitVolume& skeleton, const voxel::DistanceField& distance,
                            const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
