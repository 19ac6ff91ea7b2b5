#include "index/up.h"

#include <string>

namespace ossuary::index {

std::string_view to_string(Up up) { return up == Up::kY ? "y" : "z"; }

Result<Up> parse_up(std::string_view text) {
    if (text == "y") return Up::kY;
    if (text == "z") return Up::kZ;
    return {ErrorCode::kInvalidArgument, "up: '" + std::string(text) + "', expected y or z"};
}

Vec3 up_direction(Up up) { return up == Up::kY ? Vec3::UnitY() : Vec3::UnitZ(); }

Vec3 viewer_direction(Up up) {
    constexpr double kRight = 0.55, kAbove = 0.45, kFront = 1.0;
    // Where z is up, -y is the front: the turn that takes one to the other.
    return up == Up::kY ? Vec3(kRight, kAbove, kFront) : Vec3(kRight, -kFront, kAbove);
}

}  // namespace ossuary::index
