#pragma once

#include <string_view>

#include "engine/core/geometry.h"
#include "engine/core/result.h"

namespace ossuary::index {

/// The axis of a model's coordinates that points up. Formats say or mean y or z, but for COLLADA
/// and FBX, whose files may say x.
enum class Up { kX, kY, kZ };

[[nodiscard]] std::string_view to_string(Up up);  ///< "x", "y", "z"

/// Errors: invalid_argument for anything but these.
Result<Up> parse_up(std::string_view text);

/// The direction itself, and the one towards a viewer who sees the model from the front, from a
/// little above and from its left.
[[nodiscard]] Vec3 up_direction(Up up);
[[nodiscard]] Vec3 viewer_direction(Up up);

}  // namespace ossuary::index
