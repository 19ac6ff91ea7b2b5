#include "index/reader/gltf_primitive.h"

#include <numeric>
#include <string>
#include <utility>

namespace ossuary::index {
namespace {

Error invalid(const std::string& found) {
    return {ErrorCode::kGltfInvalid, "expected triangles, found " + found};
}

/// From the corners of a strip or fan to those of triangles that all face the same way.
std::vector<std::uint32_t> unrolled(const std::vector<std::uint32_t>& corners, bool fan) {
    std::vector<std::uint32_t> triangles;
    if (corners.size() < 3) return triangles;
    triangles.reserve(3 * (corners.size() - 2));
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        if (fan) {
            triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
        } else {
            const std::size_t odd = i % 2;
            triangles.insert(triangles.end(),
                             {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
        }
    }
    return triangles;
}

/// A whole number in a Draco extension; -1 where there is none.
int number_in(const tinygltf::Value& object, const char* name) {
    if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsInt()) return -1;
    return object.Get(name).Get<int>();
}

Result<GltfTriangles> from_draco(const tinygltf::Value& extension, GltfAccessors& accessors,
                                 const mesh::ReadMeshOptions& caps) {
    const int view_number = number_in(extension, "bufferView");
    const int position = number_in(extension.Get("attributes"), "POSITION");
    if (view_number < 0 || position < 0) {
        return invalid("a Draco extension without its view or positions");
    }
    const auto bytes = accessors.view(view_number);
    if (!bytes) return bytes.error();
    const int colour = number_in(extension.Get("attributes"), "COLOR_0");
    return decode_draco(*bytes, static_cast<std::uint32_t>(position), colour, caps);
}

}  // namespace

bool has_triangles(const tinygltf::Primitive& primitive) {
    // tinygltf says -1 where the file says nothing, which means triangles.
    return primitive.mode == -1 || (primitive.mode >= TINYGLTF_MODE_TRIANGLES &&
                                    primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN);
}

Result<GltfTriangles> triangles_of(const tinygltf::Primitive& primitive, GltfAccessors& accessors,
                                   const mesh::ReadMeshOptions& caps) {
    const auto draco = primitive.extensions.find("KHR_draco_mesh_compression");
    if (draco != primitive.extensions.end()) return from_draco(draco->second, accessors, caps);
    const auto position = primitive.attributes.find("POSITION");
    // A primitive without positions shows nothing, says the specification.
    if (position == primitive.attributes.end()) return GltfTriangles{};
    auto positions = accessors.positions(position->second);
    if (!positions) return positions.error();
    GltfTriangles triangles{*std::move(positions), {}};
    const auto colour = primitive.attributes.find("COLOR_0");
    if (colour != primitive.attributes.end()) {
        // Those that cannot be used keep no surface from being read.
        auto colours = accessors.colours(colour->second, triangles.positions.size());
        if (colours) triangles.colours = *std::move(colours);
    }
    if (primitive.indices >= 0) {
        auto corners = accessors.indices(primitive.indices);
        if (!corners) return corners.error();
        triangles.corners = *std::move(corners);
    } else {
        triangles.corners.resize(triangles.positions.size());
        std::iota(triangles.corners.begin(), triangles.corners.end(), 0u);
    }
    for (const std::uint32_t corner : triangles.corners) {
        if (corner >= triangles.positions.size()) {
            return invalid("corner " + std::to_string(corner) + " of " +
                           std::to_string(triangles.positions.size()) + " vertices");
        }
    }
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
        primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        triangles.corners =
            unrolled(triangles.corners, primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN);
    }
    triangles.corners.resize(triangles.corners.size() / 3 * 3);
    return triangles;
}

}  // namespace ossuary::index
