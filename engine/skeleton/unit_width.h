#pragma once

#include <stop_token>

#include "engine/skeleton/thinning_grid.h"

namespace ossuary::skeleton {

/// Thins the crowds of a curve-like set to unit width in the manner of the valence-driven spatial
/// median (Wang & Basu, "A curve skeleton of unit width", see thesis sec. 3.2.1): the removable
/// voxels (simple points with at least two neighbours) form crowds; in each, those farthest from
/// the crowd's spatial median go first, those of lower valence among equals, one at a time. What is
/// left has no removable voxel: every simple point is an end. Closed surfaces around cavities stay.
void thin_to_unit_width(ThinningGrid& object, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
