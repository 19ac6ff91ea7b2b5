// Feeds arbitrary nodes and struts to what makes surfaces of lattices: eight nodes of floats, then
// struts of ten bytes.

#include "index/reader/beam_lattice.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/fuzz/require.h"

namespace {

using namespace ossuary;

constexpr std::size_t kNodes = 8;
constexpr std::size_t kBytesOfStrut = 10;

float float_at(const std::uint8_t* bytes) {
    float value = 0.0F;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
}

index::Beam beam_at(const std::uint8_t* bytes) {
    // One number more than there are nodes.
    const auto node = [](std::uint8_t byte) {
        return static_cast<std::uint32_t>(byte % (kNodes + 1));
    };
    index::Beam beam;
    beam.nodes = {node(bytes[0]), node(bytes[1])};
    beam.radii = {float_at(bytes + 2), float_at(bytes + 6)};
    beam.caps = {static_cast<index::BeamCap>(bytes[0] / 16 % 3),
                 static_cast<index::BeamCap>(bytes[1] / 16 % 3)};
    return beam;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kBytesOfNodes = kNodes * 3 * sizeof(float);
    if (size < kBytesOfNodes) return 0;
    std::vector<Vec3> nodes(kNodes);
    for (std::size_t i = 0; i < kNodes; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            nodes[i][static_cast<Eigen::Index>(axis)] = float_at(data + 12 * i + 4 * axis);
        }
        // As the reader has looked at them.
        if (!nodes[i].allFinite() || nodes[i].cwiseAbs().maxCoeff() > 1e30) return 0;
    }
    std::vector<index::Beam> beams;
    for (std::size_t at = kBytesOfNodes; at + kBytesOfStrut <= size; at += kBytesOfStrut) {
        beams.push_back(beam_at(data + at));
    }
    mesh::ReadMeshOptions caps;
    caps.max_vertices = caps.max_faces = 20'000;
    const auto surface = index::beam_lattice_surface(nodes, beams, caps);
    if (!surface) {
        fuzz::require(!surface.error().message.empty());
        return 0;
    }
    fuzz::require(surface->vertices.size() <= caps.max_vertices);
    fuzz::require(surface->triangles.size() <= caps.max_faces);
    for (const auto& triangle : surface->triangles) {
        for (const std::uint32_t vertex : triangle)
            fuzz::require(vertex < surface->vertices.size());
    }
    for (const Vec3& vertex : surface->vertices) fuzz::require(vertex.allFinite());
    return 0;
}
