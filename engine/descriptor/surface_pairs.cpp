#include "engine/descriptor/surface_pairs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "engine/descriptor/histogram.h"
#include "engine/descriptor/quantize.h"

namespace ossuary::descriptor {
namespace {

constexpr std::size_t kMaxPoints = 300;

}  // namespace

std::vector<std::uint8_t> surface_pairs(const ShellGraph& graph) {
    SoftHistogram<4> histogram({{{0.0, 1.4, 8}, {-1.0, 1.0, 5}, {-1.0, 1.0, 5}, {-1.0, 1.0, 5}}});
    // Nodes run along the grid, so that every stride-th spreads over the surface.
    const std::size_t stride = (graph.size() + kMaxPoints - 1) / kMaxPoints;
    const float scale = 1.0F / static_cast<float>(std::sqrt(graph.total_area));
    for (std::size_t i = 0; i < graph.size(); i += stride) {
        for (std::size_t j = i + stride; j < graph.size(); j += stride) {
            Vec3f line = graph.points[j] - graph.points[i];
            const float distance = line.norm();
            if (distance < 1e-6F) continue;
            line /= distance;
            const float leaving = graph.normals[i].dot(line);
            const float arriving = -graph.normals[j].dot(line);
            histogram.add({static_cast<double>(distance * scale),
                           static_cast<double>(std::max(leaving, arriving)),
                           static_cast<double>(std::min(leaving, arriving)),
                           static_cast<double>(graph.normals[i].dot(graph.normals[j]))},
                          static_cast<double>(graph.areas[i] * graph.areas[j]));
        }
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(kSurfacePairsSize);
    append_root_bytes(histogram.normalized(), kHistogramByteScale, bytes);
    return bytes;
}

double squared_byte_distance(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    assert(a.size() == b.size());
    std::uint64_t sum = 0;
    constexpr std::size_t kBlock = 1024;  // 32 bits hold its sum
    for (std::size_t begin = 0; begin < a.size(); begin += kBlock) {
        const std::size_t end = std::min(a.size(), begin + kBlock);
        std::int32_t block = 0;
        for (std::size_t i = begin; i < end; ++i) {
            block += std::abs(int{a[i]} * int{a[i]} - int{b[i]} * int{b[i]});
        }
        sum += static_cast<std::uint64_t>(block);
    }
    return static_cast<double>(sum);
}

}  // namespace ossuary::descriptor
