#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/result.h"

namespace ossuary::chain_code {

/// The descriptor of eq. 3.5 for the step `d` after the two preceding differing directions `b`,
/// then `c`: '0' straight on, '1' d = b x c, '2' d = b, '3' d = -(b x c), '4' d = -b. While the
/// path has not turned yet (`b` zero) every turn is alike and has the highest value, '4'.
/// @pre c and d are unit steps, d is not -c, b is a unit step across c or zero
[[nodiscard]] char chain_element(const Vec3i& b, const Vec3i& c, const Vec3i& d);

/// The relative chain code of a path of unit steps, one character for each step but the first
/// (thesis sec. 3.3.2). It does not change under translation and the lattice's rotations.
/// @pre neighbouring voxels differ by a unit step and no step takes back the one before it
[[nodiscard]] std::string five_element_code(std::span<const Vec3i> path);

/// A path with this code: from the origin along x, its first turn towards -y. All others with the
/// same code are its rotated and shifted copies.
/// Errors: invalid_argument for a character that is not '0'-'4'.
Result<std::vector<Vec3i>> decode_five_element_code(std::string_view code);

}  // namespace ossuary::chain_code
