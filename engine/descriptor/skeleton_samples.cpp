#include "engine/descriptor/skeleton_samples.h"

#include <algorithm>

#include "engine/descriptor/quantize.h"

namespace ossuary::descriptor {
namespace {

constexpr double kLeastRadius = 1e-4;

Vec3f point_of(const matching::SkeletonDescriptor::Branch& branch, std::size_t i) {
    return {branch.points[3 * i], branch.points[3 * i + 1], branch.points[3 * i + 2]};
}

}  // namespace

std::vector<SkeletonSample> skeleton_samples(const matching::SkeletonDescriptor& skeleton) {
    std::vector<SkeletonSample> samples;
    for (std::uint32_t index = 0; index < skeleton.branches.size(); ++index) {
        const matching::SkeletonDescriptor::Branch& branch = skeleton.branches[index];
        const auto steps = static_cast<double>(branch.radii.size() - 1);
        const double step = static_cast<double>(branch.length) / steps;
        for (std::size_t i = 1; i < branch.radii.size(); ++i) {
            const auto radius = static_cast<double>(0.5F * (branch.radii[i - 1] + branch.radii[i]));
            samples.push_back({0.5F * (point_of(branch, i - 1) + point_of(branch, i)),
                               std::max(radius, kLeastRadius), step, index,
                               step * (static_cast<double>(i) - 0.5)});
        }
    }
    if (samples.empty() && !skeleton.nodes.empty()) {
        const auto radius = static_cast<double>(skeleton.nodes.front().radius);
        samples.assign(2, {Vec3f::Zero(), std::max(radius, kLeastRadius), 1.0, 0, 0.0});
    }
    return samples;
}

std::vector<std::uint8_t> mean_root_bytes(
    std::span<const matching::SkeletonDescriptor> skeletons, std::size_t size, double scale,
    std::vector<float> (*histogram_of)(const matching::SkeletonDescriptor&, const std::stop_token&),
    const std::stop_token& stop) {
    std::vector<float> mean(size, 0.0F);
    for (const matching::SkeletonDescriptor& skeleton : skeletons) {
        const std::vector<float> histogram = histogram_of(skeleton, stop);
        for (std::size_t i = 0; i < size; ++i) {
            mean[i] += histogram[i] / static_cast<float>(skeletons.size());
        }
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(size);
    append_root_bytes(mean, scale, bytes);
    return bytes;
}

}  // namespace ossuary::descriptor
