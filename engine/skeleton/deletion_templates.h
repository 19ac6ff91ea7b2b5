#pragma once

#include "engine/skeleton/neighborhood.h"

namespace ossuary::skeleton {

/// Whether a neighbourhood fits one of the deletion templates of fully parallel thinning (Ma &
/// Sonka, "A fully parallel 3D thinning algorithm and its applications", 1996), in their classes
///   A  (6)  nine white voxels on one side, a black one opposite;
///   B (12)  two adjoining sides' worth of white, black opposite both;
///   C  (8)  the seven voxels of one octant white, black faces opposite the three white ones;
///   D (12)  white all round in one mid-plane but for one black edge neighbour.
/// These are candidates only: class D deletes wrongly in parallel (Wang & Basu, arXiv 1905.03705),
/// which the P-simple test puts right.
[[nodiscard]] bool matches_deletion_template(Neighborhood object);

/// The end of a line, or the last but one: a single neighbour, or two that touch each other. Such
/// points are never candidates, so that lines keep their ends.
[[nodiscard]] bool is_tail(Neighborhood object);

}  // namespace ossuary::skeleton
