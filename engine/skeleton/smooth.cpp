#include "engine/skeleton/smooth.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace ossuary::skeleton {
namespace {

using Sample = Eigen::Vector4d;  // x, y, z, radius

std::vector<Sample> samples_of(const SkeletonGraph::Branch& branch) {
    std::vector<Sample> samples(branch.points.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] << branch.points[i], branch.radii[i];
    }
    return samples;
}

void set_sample(SkeletonGraph::Branch& branch, std::size_t i, const Sample& sample) {
    branch.points[i] = sample.head<3>();
    branch.radii[i] = sample[3];
}

/// One side of a Gaussian, the whole summing to one, cut off at three standard deviations or
/// `longest`.
std::vector<double> half_kernel(double variance, std::size_t longest) {
    const auto reach = static_cast<std::size_t>(std::ceil(3.0 * std::sqrt(variance)));
    std::vector<double> kernel(std::min(reach, longest) + 1);
    double sum = 0.0;
    for (std::size_t k = 0; k < kernel.size(); ++k) {
        const auto offset = static_cast<double>(k);
        kernel[k] = std::exp(-offset * offset / (2.0 * variance));
        sum += k == 0 ? kernel[k] : 2.0 * kernel[k];
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

double sine_between(const Vec3& a, const Vec3& b) {
    const double lengths = a.norm() * b.norm();
    return lengths > 0.0 ? a.cross(b).norm() / lengths : 0.0;
}

/// Sum of the sines of eq. 3.4 over the points of a curve.
double sine_sum(std::span<const Vec3> points) {
    const Vec3& start = points.front();
    const Vec3& end = points.back();
    double sum = 0.0;
    for (const Vec3& point : points) {
        sum += sine_between(end - start, point - start) + sine_between(start - end, point - end);
    }
    return sum;
}

}  // namespace

double bending(const SkeletonGraph::Branch& branch) {
    const std::span<const Vec3> points(branch.points);
    const auto count = static_cast<double>(points.size());
    if (branch.a != branch.b) return sine_sum(points) / (2.0 * count);
    const std::size_t half = points.size() / 2;
    return (sine_sum(points.first(half + 1)) + sine_sum(points.subspan(half))) /
           (2.0 * (count + 1.0));
}

double smoothing_variance(const SkeletonGraph::Branch& branch, SmoothingScale scale,
                          double max_variance) {
    const double halves = branch.a == branch.b ? 2.0 : 1.0;
    const double count = static_cast<double>(branch.points.size()) / halves;
    const double bent = bending(branch);
    double variance = 0.0;
    switch (scale) {
        case SmoothingScale::kBendingSum:
            variance = bent * count;
            break;
        case SmoothingScale::kQuotient:
            variance = bent * max_variance > count ? count / bent : max_variance;
            break;
        case SmoothingScale::kFixed:
            break;
    }
    return std::min(variance, max_variance);
}

void smooth_branch(SkeletonGraph::Branch& branch, double variance) {
    if (variance <= 0.0 || branch.points.size() < 3) return;
    const std::vector<Sample> samples = samples_of(branch);
    const std::size_t last = samples.size() - 1;
    const std::vector<double> kernel = half_kernel(variance, last);
    const Sample twice_first = 2.0 * samples.front();
    const Sample twice_last = 2.0 * samples.back();
    for (std::size_t i = 1; i < last; ++i) {
        Sample sum = kernel[0] * samples[i];
        for (std::size_t k = 1; k < kernel.size(); ++k) {
            const Sample before = k <= i ? samples[i - k] : Sample(twice_first - samples[k - i]);
            const Sample after =
                i + k <= last ? samples[i + k] : Sample(twice_last - samples[2 * last - i - k]);
            sum += kernel[k] * (before + after);
        }
        // The reflection of a radius in a small one may fall below zero.
        sum[3] = std::max(sum[3], 0.0);
        set_sample(branch, i, sum);
    }
}

void smooth_closed_branch(SkeletonGraph::Branch& branch, SkeletonGraph::Node& node,
                          double variance) {
    if (variance <= 0.0 || branch.points.size() < 4) return;
    std::vector<Sample> samples = samples_of(branch);
    samples.pop_back();  // the first again
    const std::size_t count = samples.size();
    const std::vector<double> kernel = half_kernel(variance, (count - 1) / 2);
    for (std::size_t i = 0; i < count; ++i) {
        Sample sum = kernel[0] * samples[i];
        for (std::size_t k = 1; k < kernel.size(); ++k) {
            sum += kernel[k] * (samples[(i + count - k) % count] + samples[(i + k) % count]);
        }
        set_sample(branch, i, sum);
    }
    branch.points.back() = branch.points.front();
    branch.radii.back() = branch.radii.front();
    node.position = branch.points.front();
    node.radius = branch.radii.front();
}

}  // namespace ossuary::skeleton
