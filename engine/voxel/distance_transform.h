#pragma once

#include "engine/voxel/distance_field.h"

namespace ossuary {

/// Exact, separable, in one pass along each axis; deterministic. Up to 356 voxels a side the
/// columns are searched by vector instructions (distance_scan.h), above that lower envelopes of
/// parabolas are built (distance_envelope.h).
DistanceField distance_transform(const BitVolume& volume);

}  // namespace ossuary
