#pragma once

#include <string>

namespace ossuary::index {

/// What a unit of length is called: um, mm, cm, m, km, inch, foot, yard; others by their length,
/// `0.3 m`. Empty for 0.
[[nodiscard]] std::string unit_name(double metres_per_unit);

}  // namespace ossuary::index
