#pragma once

#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::matching {

/// A curve with its radii at evenly spaced points.
struct ResampledCurve {
    std::vector<Vec3f> points;
    std::vector<float> radii;
    double length = 0.0;  ///< of the curve that was resampled, in its unit
};

/// `points` at even steps of its arc length, as near to `step` as a whole number of them allows and
/// at most `max_samples` points; at least two points, both ends kept.
/// @pre points.size() == radii.size(), at least one point, step > 0, max_samples >= 2
[[nodiscard]] ResampledCurve resample(std::span<const Vec3> points, std::span<const double> radii,
                                      double step, int max_samples);

/// The part of an evenly spaced curve between two shares of its length, walked from `from` to `to`,
/// in `steps` equal steps.
/// @param coordinates  x y z of each point
/// @pre at least two points, steps >= 1
[[nodiscard]] ResampledCurve resample_evenly(std::span<const float> coordinates,
                                             std::span<const float> radii, double from, double to,
                                             int steps);

/// The same at steps as near to the curve's own as possible and at most `max_steps` of them. The
/// whole of a curve with no more steps comes back unchanged or reversed.
[[nodiscard]] ResampledCurve resample_part(std::span<const float> coordinates,
                                           std::span<const float> radii, double from, double to,
                                           int max_steps);

}  // namespace ossuary::matching
