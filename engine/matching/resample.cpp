#include "engine/matching/resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace ossuary::matching {

ResampledCurve resample(std::span<const Vec3> points, std::span<const double> radii, double step,
                        int max_samples) {
    assert(points.size() == radii.size() && !points.empty() && step > 0.0 && max_samples >= 2);
    std::vector<double> along(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        along[i] = along[i - 1] + (points[i] - points[i - 1]).norm();
    }
    ResampledCurve curve;
    curve.length = along.back();
    const double wanted = std::round(curve.length / step);
    const int steps = static_cast<int>(std::clamp(wanted, 1.0, max_samples - 1.0));
    std::size_t segment = 0;
    for (int k = 0; k <= steps; ++k) {
        const double at = curve.length * k / steps;
        while (segment + 2 < points.size() && along[segment + 1] < at) ++segment;
        const std::size_t next = std::min(segment + 1, points.size() - 1);
        const double span = along[next] - along[segment];
        const double share = span > 0.0 ? std::clamp((at - along[segment]) / span, 0.0, 1.0) : 0.0;
        const Vec3 point = points[segment] + share * (points[next] - points[segment]);
        curve.points.emplace_back(point.cast<float>());
        curve.radii.push_back(
            static_cast<float>(radii[segment] + share * (radii[next] - radii[segment])));
    }
    return curve;
}

ResampledCurve resample_evenly(std::span<const float> coordinates, std::span<const float> radii,
                               double from, double to, int steps) {
    assert(coordinates.size() == 3 * radii.size() && radii.size() >= 2 && steps >= 1);
    const auto last = static_cast<double>(radii.size() - 1);
    ResampledCurve curve;
    for (int k = 0; k <= steps; ++k) {
        const double at = std::clamp(last * (from + (to - from) * k / steps), 0.0, last);
        const auto index = static_cast<std::size_t>(std::min(std::floor(at), last - 1.0));
        const auto share = static_cast<float>(at - static_cast<double>(index));
        const Vec3f p(&coordinates[3 * index]);
        const Vec3f q(&coordinates[3 * index + 3]);
        curve.points.emplace_back(p + share * (q - p));
        curve.radii.push_back(radii[index] + share * (radii[index + 1] - radii[index]));
        if (k > 0) curve.length += (curve.points.back() - *std::prev(curve.points.end(), 2)).norm();
    }
    return curve;
}

ResampledCurve resample_part(std::span<const float> coordinates, std::span<const float> radii,
                             double from, double to, int max_steps) {
    const auto last = static_cast<double>(radii.size() - 1);
    const int wanted = static_cast<int>(std::round(last * std::abs(to - from)));
    return resample_evenly(coordinates, radii, from, to, std::clamp(wanted, 1, max_steps));
}

}  // namespace ossuary::matching
