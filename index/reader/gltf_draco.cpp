#include "index/reader/gltf_draco.h"

#include <draco/compression/decode.h>

#include <array>
#include <memory>
#include <string>

namespace ossuary::index {
namespace {

/// The colours of all points; none where they are of no use.
std::vector<std::array<float, 3>> colours_of(const draco::Mesh& mesh,
                                             const draco::PointAttribute* attribute) {
    std::vector<std::array<float, 3>> colours;
    if (attribute == nullptr || attribute->num_components() < 3) return colours;
    // Integers that are not marked as normalised are meant so, too.
    float whole = 1.0F;
    if (!attribute->normalized() && attribute->data_type() == draco::DT_UINT8) whole = 255.0F;
    if (!attribute->normalized() && attribute->data_type() == draco::DT_UINT16) whole = 65'535.0F;
    colours.reserve(mesh.num_points());
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        std::array<float, 4> value{};
        if (!attribute->ConvertValue<float, 4>(attribute->mapped_index(point), value.data())) {
            return {};
        }
        colours.push_back({value[0] / whole, value[1] / whole, value[2] / whole});
    }
    return colours;
}

}  // namespace

Result<GltfTriangles> decode_draco(std::span<const unsigned char> bytes, std::uint32_t position,
                                   int colour, const mesh::ReadMeshOptions& caps) {
    const auto invalid = [](const std::string& found) -> Error {
        return {ErrorCode::kGltfInvalid, "expected a mesh compressed with Draco, found " + found};
    };
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) return invalid("damage: " + decoded.status().error_msg_string());
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(position);
    if (attribute == nullptr || attribute->num_components() != 3) return invalid("no positions");
    if (mesh->num_points() > caps.max_vertices) {
        return {ErrorCode::kModelTooManyVertices,
                "expected at most " + std::to_string(caps.max_vertices) + " vertices, found " +
                    std::to_string(mesh->num_points())};
    }
    if (mesh->num_faces() > caps.max_triangles) {
        return {ErrorCode::kModelTooManyFaces,
                "expected at most " + std::to_string(caps.max_triangles) + " triangles, found " +
                    std::to_string(mesh->num_faces())};
    }
    GltfTriangles triangles;
    triangles.positions.reserve(mesh->num_points());
    for (draco::PointIndex point(0); point < mesh->num_points(); ++point) {
        std::array<float, 3> value{};
        if (!attribute->ConvertValue<float, 3>(attribute->mapped_index(point), value.data())) {
            return invalid("positions that cannot be used");
        }
        triangles.positions.emplace_back(double{value[0]}, double{value[1]}, double{value[2]});
    }
    if (colour >= 0) {
        const auto* colours = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(colour));
        triangles.colours = colours_of(*mesh, colours);
    }
    triangles.corners.reserve(std::size_t{3} * mesh->num_faces());
    for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face) {
        for (const auto& corner : mesh->face(face)) {
            triangles.corners.push_back(corner.value());
        }
    }
    return triangles;
}

}  // namespace ossuary::index
