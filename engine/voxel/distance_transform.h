#pragma once

#include <stop_token>

#include "engine/voxel/distance_field.h"

namespace ossuary::voxel {

/// Exact, separable, in one pass along each axis; deterministic. Columns are
/// searched by vector instructions (distance_scan.h); where some voxel is more than 178 from the
/// background, lower envelopes of parabolas are built (distance_envelope.h). Not complete when
/// `stop` is requested.
DistanceField distance_transform(const BitVolume& volume, const std::stop_token& stop = {});

}  // namespace ossuary::voxel
