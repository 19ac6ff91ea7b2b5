#pragma once

#include <cmath>

namespace ossuary::descriptor {

/// The length that a solid's descriptors are measured in, in the unit of its grid: the geometric
/// mean of the square root of its surface area and of the cube root of its volume, the latter times
/// 3.06 so that both are alike for a body of limbs. Roughness raises the area, holes and sheets
/// lower the volume: together they move the scale half as much.
inline double body_scale(double area, double volume) {
    constexpr double kVolumeGain = 3.06;
    return std::sqrt(std::sqrt(area) * kVolumeGain * std::cbrt(volume));
}

}  // namespace ossuary::descriptor
