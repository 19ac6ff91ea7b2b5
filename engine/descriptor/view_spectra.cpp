#include "engine/descriptor/view_spectra.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/descriptor/byte_distance.h"
#include "engine/descriptor/image_spectrum.h"
#include "engine/descriptor/quantize.h"
#include "engine/descriptor/view_images.h"

namespace ossuary::descriptor {
namespace {

constexpr double kSpectrumByteScale = 255.0;
constexpr std::size_t kPanoramaPart = 2 * kPanoramaSpectrum;
constexpr std::size_t kDepthPart = 4 * kDepthSpectrum;
constexpr std::size_t kFrameSize = 3 * kViewSize;

void append_depth(const std::vector<float>& front, const std::vector<float>& back,
                  std::vector<std::uint8_t>& bytes) {
    std::vector<float> mean, difference;
    for (std::size_t i = 0; i < front.size(); ++i) {
        mean.push_back(0.5F * (front[i] + back[i]));
        difference.push_back(0.5F * std::abs(front[i] - back[i]));
    }
    append_root_bytes(mean, kSpectrumByteScale, bytes);
    append_root_bytes(difference, kSpectrumByteScale, bytes);
}

void append_view(const SolidSurface& surface, const PrincipalFrame& frame, int axis,
                 std::vector<std::uint8_t>& bytes) {
    static const ImageSpectrum kAround({kPanoramaRows, kPanoramaColumns}, {9, 16});
    static const ImageSpectrum kAlong({kDepthSide, kDepthSide},
                                      {kDepthFrequencies, kDepthFrequencies});
    const ViewImage around = panorama(surface, frame, axis);
    append_root_bytes(kAround.magnitudes(around.extent), kSpectrumByteScale, bytes);
    append_root_bytes(kAround.magnitudes(around.facing), kSpectrumByteScale, bytes);
    const std::array<ViewImage, 2> along = depth_images(surface, frame, axis);
    append_depth(kAlong.magnitudes(along[0].extent), kAlong.magnitudes(along[1].extent), bytes);
    append_depth(kAlong.magnitudes(along[0].facing), kAlong.magnitudes(along[1].facing), bytes);
}

/// The depth part of a view with the image's two axes exchanged.
using Turned = std::array<std::uint8_t, kDepthPart>;
Turned turned(const std::uint8_t* depth) {
    Turned result;
    for (std::size_t part = 0; part < kDepthPart; part += kDepthSpectrum) {
        for (std::size_t row = 0; row < kDepthFrequencies; ++row) {
            for (std::size_t column = 0; column < kDepthFrequencies; ++column) {
                result[part + row * kDepthFrequencies + column] =
                    depth[part + column * kDepthFrequencies + row];
            }
        }
    }
    return result;
}

std::uint32_t frame_distance(const std::uint8_t* a, const std::uint8_t* b) {
    // Distances of each view of a from each of b; the images' axes are in the same order when the
    // three axes go round in the same sense, else exchanged.
    std::array<std::array<std::uint32_t, 3>, 3> same{}, exchanged{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint8_t* view = a + i * kViewSize;
        const Turned view_turned = turned(view + kPanoramaPart);
        for (std::size_t j = 0; j < 3; ++j) {
            const std::uint8_t* other = b + j * kViewSize;
            const std::uint32_t around = byte_distance(view, other, kPanoramaPart);
            same[i][j] =
                around + byte_distance(view + kPanoramaPart, other + kPanoramaPart, kDepthPart);
            exchanged[i][j] =
                around + byte_distance(view_turned.data(), other + kPanoramaPart, kDepthPart);
        }
    }
    std::uint32_t best = std::numeric_limits<std::uint32_t>::max();
    for (std::size_t shift = 0; shift < 3; ++shift) {
        std::uint32_t cyclic = 0, mirrored = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            cyclic += same[i][(i + shift) % 3];
            mirrored += exchanged[i][(3 + shift - i) % 3];
        }
        best = std::min({best, cyclic, mirrored});
    }
    return best;
}

}  // namespace

std::vector<std::uint8_t> view_spectra(const SolidSurface& surface) {
    if (surface.empty()) return std::vector<std::uint8_t>(kViewSpectraSize, 0);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kViewSpectraSize);
    for (const FrameKind kind : {FrameKind::kPositions, FrameKind::kNormals}) {
        const PrincipalFrame frame = principal_frame(surface, kind);
        for (int axis = 0; axis < 3; ++axis) append_view(surface, frame, axis, bytes);
    }
    return bytes;
}

double view_distance(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    assert(a.size() == kViewSpectraSize && b.size() == kViewSpectraSize);
    std::uint32_t sum = 0;
    for (std::size_t frame = 0; frame < kViewFrames; ++frame) {
        sum += frame_distance(a.data() + frame * kFrameSize, b.data() + frame * kFrameSize);
    }
    return static_cast<double>(sum);
}

}  // namespace ossuary::descriptor
