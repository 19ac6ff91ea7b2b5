#pragma once

#include "engine/voxel/distance_field.h"

namespace ossuary::voxel {

/// Exact, separable, in one pass along each axis; deterministic. Columns are
/// searched by vector instructions (distance_scan.h); where some voxel is more than 178 from the
/// background, lower envelopes of parabolas are built (distance_envelope.h).
DistanceField distance_transform(const BitVolume& volume);

}  // namespace ossuary::voxel
