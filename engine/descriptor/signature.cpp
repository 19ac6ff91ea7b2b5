#include "engine/descriptor/signature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/chain_code/direction_code.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/histogram.h"
#include "engine/descriptor/view_spectra.h"

namespace ossuary::descriptor {
namespace {

constexpr std::size_t kPart = 64;
constexpr std::size_t kParts = 4;
static_assert(kPart * kParts == kSignatureSize);

/// Length of skeleton over (distance from the root, level of the radius).
std::vector<float> skeleton_part(const matching::SkeletonDescriptor& skeleton) {
    // Levels 100 to 196 are radii from 0.02 to 0.36 of the scale.
    SoftHistogram<2> histogram({{{0.0, 2.0, 8}, {100.0, 196.0, 8}}});
    if (!skeleton.rooted.trees.empty()) {
        for (const matching::RootedTree::Node& node : skeleton.rooted.trees.front().nodes) {
            if (node.piece == matching::kNoIndex) continue;
            const auto code = skeleton.rooted.code(node.piece);
            const double step = static_cast<double>(skeleton.rooted.pieces[node.piece].length) /
                                static_cast<double>(std::max<std::size_t>(code.size(), 1));
            double distance = static_cast<double>(node.root_distance) + 0.5 * step;
            for (const chain_code::DirectionStep& taken : code) {
                histogram.add({distance, static_cast<double>(taken.radius_level)}, step);
                distance += step;
            }
        }
    }
    std::vector<float> values = histogram.normalized();
    for (float& value : values) value = std::sqrt(value);
    return values;
}

/// The mass of a histogram's bins, whose square roots are its bytes.
double mass(std::uint8_t root) { return static_cast<double>(root) * static_cast<double>(root); }

/// Low frequencies of the two frames' three views together, so that the order of axes is out:
/// 5 x 3 of the panoramas' extent and facing, 4 x 4 of the depth images' mean extent and facing.
std::vector<float> views_part(const std::vector<std::uint8_t>& bytes) {
    std::vector<double> sums(kPart, 0.0);
    for (std::size_t view = 0; view < kViewFrames * 3; ++view) {
        const std::uint8_t* at = bytes.data() + view * kViewSize;
        std::size_t out = 0;
        for (const std::size_t image : {std::size_t{0}, kPanoramaSpectrum}) {
            for (std::size_t row = 0; row < 3; ++row) {
                for (std::size_t column = 0; column < 5; ++column) {
                    sums[out++] += at[image + row * 16 + column];
                }
            }
        }
        const std::uint8_t* depth = at + 2 * kPanoramaSpectrum;
        for (const std::size_t image : {std::size_t{0}, 2 * kDepthSpectrum}) {
            for (std::size_t row = 0; row < 4; ++row) {
                for (std::size_t column = 0; column < 4; ++column) {
                    sums[out++] += 0.5 * (depth[image + row * kDepthFrequencies + column] +
                                          depth[image + column * kDepthFrequencies + row]);
                }
            }
        }
    }
    return {sums.begin(), sums.end()};
}

/// Distance against the angle between the normals (8 x 5), and the two other angles (24 of 25).
std::vector<float> pairs_part(const std::vector<std::uint8_t>& bytes) {
    std::vector<double> sums(kPart + 1, 0.0);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        sums[(i / 125) * 5 + i % 5] += mass(bytes[i]);
        sums[40 + (i / 5) % 25] += mass(bytes[i]);
    }
    std::vector<float> values;
    for (std::size_t i = 0; i < kPart; ++i)
        values.push_back(static_cast<float>(std::sqrt(sums[i])));
    return values;
}

/// Distance from the centre against thickness (6 x 5), small cubes against large ones (4 x 8).
std::vector<float> thickness_part(const std::vector<std::uint8_t>& thickness,
                                  const std::vector<std::uint8_t>& volume) {
    std::vector<double> sums(kPart, 0.0);
    for (std::size_t i = 0; i < thickness.size(); ++i) {
        sums[(i / 100) * 5 + (i % 50) / 10] += mass(thickness[i]);
    }
    constexpr std::size_t kFirst = 12 * 8;  // the histogram by geodesic distance stays out
    for (std::size_t i = kFirst; i < volume.size(); ++i) {
        const std::size_t bin = (i - kFirst) / 6;
        sums[30 + (bin / 16) * 8 + bin % 8] += mass(volume[i]);
    }
    std::vector<float> values;
    for (const double sum : sums) values.push_back(static_cast<float>(std::sqrt(sum)));
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

std::vector<float> preselection_signature(const matching::SkeletonDescriptor& skeleton,
                                          const std::vector<GlobalDescriptor>& globals) {
    assert(globals.size() == kGlobalDescriptorKinds.size());
    std::vector<float> signature;
    signature.reserve(kSignatureSize);
    append_normalized(skeleton_part(skeleton), signature);
    append_normalized(views_part(globals[kViewsPlace].values), signature);
    append_normalized(pairs_part(globals[kSurfacePairsPlace].values), signature);
    append_normalized(
        thickness_part(globals[kRadialThicknessPlace].values, globals[kLocalVolumePlace].values),
        signature);
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

}  // namespace ossuary::descriptor
