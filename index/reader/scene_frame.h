#pragma once

#include <optional>
#include <string_view>

#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

/// What a file says of its unit and of the axis that points up.
struct SceneFrame {
    double metres_per_unit = 0.0;  ///< 0 where it says nothing
    std::optional<mesh::UpAxis> up;
};

/// By `<asset>`'s `<unit meter="…">` and `<up_axis>`; metres and y where they are left out.
[[nodiscard]] SceneFrame collada_frame(std::string_view document);

/// By the unit of `<amf unit="…">`, millimetres where it is left out; z is up.
[[nodiscard]] SceneFrame amf_frame(std::string_view document);

}  // namespace ossuary::index
