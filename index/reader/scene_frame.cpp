#include "index/reader/scene_frame.h"

#include <array>
#include <utility>

#include "engine/mesh/parse_number.h"
#include "index/reader/xml_tag.h"

namespace ossuary::index {

SceneFrame collada_frame(std::string_view document) {
    SceneFrame frame{1.0, mesh::UpAxis::kY};
    const std::string_view head = document.substr(0, document.find("<library_geometries"));
    const std::string_view unit = xml_attribute(first_tag(head, "unit"), "meter");
    const auto metres = mesh::parse_double(unit.data(), unit.data() + unit.size());
    if (metres.status == mesh::NumberStatus::kOk && metres.value > 0.0) {
        frame.metres_per_unit = metres.value;
    }
    const std::size_t axis = head.find("<up_axis>");
    if (axis != std::string_view::npos) {
        const std::string_view word = head.substr(axis + 9, head.find('<', axis + 9) - axis - 9);
        if (word.find("Z_UP") != std::string_view::npos) frame.up = mesh::UpAxis::kZ;
        if (word.find("X_UP") != std::string_view::npos) frame.up = mesh::UpAxis::kX;
    }
    return frame;
}

SceneFrame amf_frame(std::string_view document) {
    constexpr std::array<std::pair<std::string_view, double>, 8> kUnits = {{{"millimeter", 1e-3},
                                                                            {"inch", 0.0254},
                                                                            {"feet", 0.3048},
                                                                            {"foot", 0.3048},
                                                                            {"meter", 1.0},
                                                                            {"centimeter", 1e-2},
                                                                            {"micron", 1e-6},
                                                                            {"micrometer", 1e-6}}};
    SceneFrame frame{1e-3, mesh::UpAxis::kZ};
    const std::string_view unit = xml_attribute(first_tag(document, "amf"), "unit");
    for (const auto& [name, metres] : kUnits) {
        if (unit == name) frame.metres_per_unit = metres;
    }
    return frame;
}

}  // namespace ossuary::index
