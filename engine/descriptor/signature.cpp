#include "engine/descriptor/signature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/chain_code/direction_code.h"
#include "engine/descriptor/depth_fourier.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/histogram.h"
#include "engine/descriptor/spherical_harmonics.h"

namespace ossuary {
namespace {

constexpr std::size_t kPart = 64;
constexpr std::size_t kParts = 4;
static_assert(kPart * kParts == kSignatureSize);

/// Length of skeleton over (distance from the root, level of the radius).
std::vector<float> skeleton_part(const SkeletonDescriptor& skeleton) {
    // Levels 100 to 196 are radii from 0.02 to 0.36 of the scale.
    JointHistogram histogram({0.0, 2.0, 8}, {100.0, 196.0, 8});
    if (!skeleton.rooted.trees.empty()) {
        for (const RootedTree::Node& node : skeleton.rooted.trees.front().nodes) {
            if (node.piece == kNoIndex) continue;
            const auto code = skeleton.rooted.code(node.piece);
            const double step = static_cast<double>(skeleton.rooted.pieces[node.piece].length) /
                                static_cast<double>(std::max<std::size_t>(code.size(), 1));
            double distance = static_cast<double>(node.root_distance) + 0.5 * step;
            for (const DirectionStep& taken : code) {
                histogram.add(distance, taken.radius_level, step);
                distance += step;
            }
        }
    }
    std::vector<float> values = histogram.normalized();
    for (float& value : values) value = std::sqrt(value);
    return values;
}

/// 16 x 16 bins to 8 x 8.
std::vector<float> histogram_part(const std::vector<float>& fine) {
    std::vector<float> values(kPart, 0.0F);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        values[(i / 32) * 8 + (i % 16) / 2] += fine[i];
    }
    for (float& value : values) value = std::sqrt(value);
    return values;
}

/// Degrees 0 to 7 of each four shells together.
std::vector<float> harmonics_part(const std::vector<float>& fine) {
    std::vector<float> values(kPart, 0.0F);
    for (std::size_t shell = 0; shell < kHarmonicShells; ++shell) {
        for (std::size_t l = 0; l < 8; ++l) {
            values[(shell / 4) * 8 + l] += fine[shell * kHarmonicDegrees + l];
        }
    }
    return values;
}

/// The lowest frequencies of the three images' means (4 x 4, then a few more of the first).
std::vector<float> depth_part(const std::vector<float>& fine) {
    constexpr auto kImage =
        static_cast<std::size_t>(kDepthFrequencies) * static_cast<std::size_t>(kDepthFrequencies);
    std::vector<float> values;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 16; ++i) {
            values.push_back(fine[axis * 2 * kImage + (i / 4) * kDepthFrequencies + i % 4]);
        }
    }
    values.resize(kPart, 0.0F);
    return values;
}

void append_normalized(std::vector<float> part, std::vector<float>& signature) {
    assert(part.size() == kPart);
    double square = 0.0;
    for (const float value : part)
        square += static_cast<double>(value) * static_cast<double>(value);
    const double scale = square > 0.0 ? 1.0 / std::sqrt(square * kParts) : 0.0;
    for (const float value : part) {
        signature.push_back(static_cast<float>(scale * static_cast<double>(value)));
    }
}

}  // namespace

std::vector<float> preselection_signature(const SkeletonDescriptor& skeleton,
                                          const std::vector<GlobalDescriptor>& globals) {
    assert(globals.size() == kGlobalDescriptorKinds.size());
    std::vector<float> signature;
    signature.reserve(kSignatureSize);
    append_normalized(skeleton_part(skeleton), signature);
    append_normalized(histogram_part(globals[0].values), signature);
    append_normalized(harmonics_part(globals[1].values), signature);
    append_normalized(depth_part(globals[2].values), signature);
    // A model without a skeleton has an empty part, so the whole is brought to unit length again.
    double square = 0.0;
    for (const float value : signature)
        square += static_cast<double>(value) * static_cast<double>(value);
    if (square > 0.0) {
        const double scale = 1.0 / std::sqrt(square);
        for (float& value : signature)
            value = static_cast<float>(scale * static_cast<double>(value));
    } else {
        signature.front() = 1.0F;
    }
    return signature;
}

}  // namespace ossuary
