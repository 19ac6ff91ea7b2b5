#pragma once

#include "engine/registration/similarity.h"
#include "engine/registration/surface_points.h"

namespace ossuary::registration {

struct RefineOptions {
    bool scale = false;  ///< settles the scale, too; else it stays what it is
    int iterations = 30;
    /// Pairs count up to this share of the target's diagonal at first, later up to what most pairs
    /// keep within, so that what has no fellow (a cap over a cut, a limb that is missing) draws
    /// nothing.
    double reach = 0.1;
    double least_reach = 0.005;
};

struct Refined {
    Similarity placement;        ///< of the source in the target
    double mean_distance = 0.0;  ///< of the pairs that count to the target's planes, its units
    double share = 0.0;          ///< of the source's points that count
};

/// Iterated closest points: each point of the source goes to the nearest of the target that faces
/// the same way, and all together move so that they come nearest to the planes there (Chen and
/// Medioni, Object Modelling by Registration of Multiple Range Images, 1992; linearised), with a
/// little of the distance between the points themselves (Besl and McKay, 1992), which settles
/// what planes leave open. A start that mirrors gives an end that does. Deterministic.
/// @pre both have points; `nearest` is of the target's
[[nodiscard]] Refined refine(const SurfacePoints& source, const SurfacePoints& target,
                             const NearestPoint& nearest, const Similarity& start,
                             const RefineOptions& options = {});

}  // namespace ossuary::registration
