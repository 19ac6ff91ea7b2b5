#include "index/up.h"

#include <string>

namespace ossuary::index {

std::string_view to_string(Up up) {
    switch (up) {
        case Up::kX:
            return "x";
        case Up::kY:
            return "y";
        case Up::kZ:
            return "z";
    }
    return "y";
}

Result<Up> parse_up(std::string_view text) {
    if (text == "x") return Up::kX;
    if (text == "y") return Up::kY;
    if (text == "z") return Up::kZ;
    return {ErrorCode::kInvalidArgument, "up: '" + std::string(text) + "', expected x, y or z"};
}

Vec3 up_direction(Up up) { return Vec3::Unit(static_cast<int>(up)); }

Vec3 viewer_direction(Up up) {
    constexpr double kRight = 0.55, kAbove = 0.45, kFront = 1.0;
    switch (up) {
        case Up::kX:  // -y to the right, as COLLADA has it
            return {kAbove, -kRight, kFront};
        case Up::kY:
            return {kRight, kAbove, kFront};
        case Up::kZ:  // -y is the front: the turn that takes one to the other
            return {kRight, -kFront, kAbove};
    }
    return Vec3::Zero();
}

}  // namespace ossuary::index
