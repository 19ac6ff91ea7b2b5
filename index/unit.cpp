#include "index/unit.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/mesh/mesh_builder.h"

namespace ossuary::index {

std::string unit_name(double metres_per_unit) {
    constexpr std::array<std::pair<std::string_view, double>, 8> kUnits = {{{"um", 1e-6},
                                                                            {"mm", 1e-3},
                                                                            {"cm", 1e-2},
                                                                            {"m", 1.0},
                                                                            {"km", 1e3},
                                                                            {"inch", 0.0254},
                                                                            {"foot", 0.3048},
                                                                            {"yard", 0.9144}}};
    constexpr double kRounding = 1e-6;  // files give some seven digits
    if (!(metres_per_unit > 0.0)) return {};
    for (const auto& [name, metres] : kUnits) {
        if (std::abs(metres_per_unit - metres) <= kRounding * metres) return std::string(name);
    }
    return mesh::number_text(metres_per_unit) + " m";
}

}  // namespace ossuary::index
