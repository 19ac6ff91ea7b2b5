#include "index/reader/read_gltf.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "index/reader/gltf_accessors.h"
#include "index/reader/gltf_document.h"
#include "index/reader/gltf_primitive.h"
#include "index/reader/scene_builder.h"

namespace ossuary::index {
namespace {

using Matrix4 = Eigen::Matrix4d;

/// Of a node below its parent.
Matrix4 matrix_of(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return Eigen::Map<const Matrix4>(node.matrix.data());
    Matrix4 matrix = Matrix4::Identity();
    if (node.rotation.size() == 4) {
        const Eigen::Quaterniond turn(node.rotation[3], node.rotation[0], node.rotation[1],
                                      node.rotation[2]);
        if (turn.norm() > 0.0) {
            matrix.topLeftCorner<3, 3>() = turn.normalized().toRotationMatrix();
        }
    }
    if (node.scale.size() == 3) {
        for (int axis = 0; axis < 3; ++axis) {
            matrix.col(axis) *= node.scale[static_cast<std::size_t>(axis)];
        }
    }
    if (node.translation.size() == 3) {
        matrix.topRightCorner<3, 1>() =
            Vec3(node.translation[0], node.translation[1], node.translation[2]);
    }
    return matrix;
}

/// The colour of a primitive's material, linear; white where it says none.
std::array<float, 3> colour_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    std::array<float, 3> colour = {1.0F, 1.0F, 1.0F};
    const auto number = static_cast<std::size_t>(primitive.material);
    if (primitive.material < 0 || number >= model.materials.size()) return colour;
    const std::vector<double>& factor =
        model.materials[number].pbrMetallicRoughness.baseColorFactor;
    for (std::size_t i = 0; i < colour.size() && i < factor.size(); ++i) {
        colour[i] = static_cast<float>(factor[i]);
    }
    return colour;
}

/// The triangles of a primitive and how they are coloured: all alike, or by their vertices.
struct ColouredTriangles {
    GltfTriangles triangles;
    mesh::Colour colour{};
    std::vector<mesh::Colour> of_vertex;
};

/// Colours of vertices are times that of the material, says the specification (sec. 3.9.2).
ColouredTriangles coloured(GltfTriangles triangles, const std::array<float, 3>& material) {
    const auto srgb = [&](const std::array<float, 3>& factor) {
        mesh::Colour colour{};
        for (std::size_t i = 0; i < colour.size(); ++i) {
            colour[i] = mesh::srgb_from_linear(factor[i] * material[i]);
        }
        return colour;
    };
    ColouredTriangles result{{}, srgb({1.0F, 1.0F, 1.0F}), {}};
    result.of_vertex.reserve(triangles.colours.size());
    for (const auto& each : triangles.colours) result.of_vertex.push_back(srgb(each));
    triangles.colours = {};
    result.triangles = std::move(triangles);
    return result;
}

class GltfReader {
public:
    GltfReader(const tinygltf::Model& model, const mesh::ReadMeshOptions& caps)
        : model_(model),
          caps_(caps),
          accessors_(model, caps),
          scene_(caps, SceneBuilder::Corners::kJoin) {}

    Result<mesh::ReadMeshResult> read();

private:
    struct Placed {
        int node = 0;
        Matrix4 matrix;
    };

    [[nodiscard]] std::vector<int> roots() const;
    Result<const std::vector<ColouredTriangles>*> mesh_of(int number);
    Result<void> add_mesh(const tinygltf::Node& node, const Matrix4& matrix);
    Result<void> add_triangles(const ColouredTriangles& coloured, const Matrix4& matrix);

    const tinygltf::Model& model_;
    const mesh::ReadMeshOptions& caps_;
    GltfAccessors accessors_;
    SceneBuilder scene_;
    std::map<int, std::vector<ColouredTriangles>> meshes_;  ///< read, by number
    std::size_t lines_and_points_ = 0;
};

std::vector<int> GltfReader::roots() const {
    if (!model_.scenes.empty()) {
        const auto number = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
        return model_.scenes[std::min(number, model_.scenes.size() - 1)].nodes;
    }
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes) {
        for (const int child : node.children) {
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size()) {
                is_child[static_cast<std::size_t>(child)] = true;
            }
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
}

Result<const std::vector<ColouredTriangles>*> GltfReader::mesh_of(int number) {
    if (const auto done = meshes_.find(number); done != meshes_.end()) return &done->second;
    if (number < 0 || static_cast<std::size_t>(number) >= model_.meshes.size()) {
        return {ErrorCode::kGltfInvalid,
                "expected the mesh of a node, found number " + std::to_string(number)};
    }
    std::vector<ColouredTriangles> primitives;
    for (const tinygltf::Primitive& primitive :
         model_.meshes[static_cast<std::size_t>(number)].primitives) {
        if (!has_triangles(primitive)) {
            ++lines_and_points_;
            continue;
        }
        auto triangles = triangles_of(primitive, accessors_, caps_);
        if (!triangles) return triangles.error();
        primitives.push_back(coloured(*std::move(triangles), colour_of(model_, primitive)));
    }
    return &(meshes_[number] = std::move(primitives));
}

Result<void> GltfReader::add_triangles(const ColouredTriangles& coloured, const Matrix4& matrix) {
    const GltfTriangles& triangles = coloured.triangles;
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    const bool mirrored = matrix.topLeftCorner<3, 3>().determinant() < 0.0;
    // Vertices that no corner refers to stay behind: primitives often share their positions.
    std::vector<std::uint32_t> numbers(triangles.positions.size(), kNone);
    for (std::size_t at = 0; at + 2 < triangles.corners.size(); at += 3) {
        std::array<std::uint32_t, 3> corners{};
        mesh::CornerColours colours = {coloured.colour, coloured.colour, coloured.colour};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t local = triangles.corners[at + corner];
            if (numbers[local] == kNone) {
                const Vec3 placed = matrix.topLeftCorner<3, 3>() * triangles.positions[local] +
                                    matrix.topRightCorner<3, 1>();
                const auto number = scene_.add_vertex(placed);
                if (!number) return number.error();
                numbers[local] = *number;
            }
            corners[corner] = numbers[local];
            if (!coloured.of_vertex.empty()) colours[corner] = coloured.of_vertex[local];
        }
        if (mirrored) {
            std::swap(corners[1], corners[2]);
            std::swap(colours[1], colours[2]);
        }
        if (auto added = scene_.add_face(corners); !added) return added;
        scene_.colour_face(corners, colours);
    }
    return {};
}

Result<void> GltfReader::add_mesh(const tinygltf::Node& node, const Matrix4& matrix) {
    const auto primitives = mesh_of(node.mesh);
    if (!primitives) return primitives.error();
    scene_.begin_object(node.name.empty() ? model_.meshes[static_cast<std::size_t>(node.mesh)].name
                                          : node.name);
    for (const ColouredTriangles& triangles : **primitives) {
        if (auto added = add_triangles(triangles, matrix); !added) return added;
    }
    scene_.end_object();
    return {};
}

Result<mesh::ReadMeshResult> GltfReader::read() {
    const auto invalid = [](const std::string& found) -> Error {
        return {ErrorCode::kGltfInvalid, "expected a tree of nodes, found " + found};
    };
    std::vector<Placed> waiting;
    const auto wait = [&](const std::vector<int>& nodes, const Matrix4& matrix) {
        // Taken from the back: the first node comes first.
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            waiting.push_back({*node, matrix});
        }
    };
    std::vector<bool> seen(model_.nodes.size(), false);
    wait(roots(), Matrix4::Identity());
    while (!waiting.empty()) {
        const Placed placed = waiting.back();
        waiting.pop_back();
        const auto number = static_cast<std::size_t>(placed.node);
        if (placed.node < 0 || number >= seen.size()) {
            return invalid("node " + std::to_string(placed.node) + ", which there is not");
        }
        if (seen[number]) return invalid("node " + std::to_string(placed.node) + " twice");
        seen[number] = true;
        const tinygltf::Node& node = model_.nodes[number];
        const Matrix4 matrix = placed.matrix * matrix_of(node);
        if (node.mesh >= 0) {
            if (auto added = add_mesh(node, matrix); !added) return added.error();
        }
        wait(node.children, matrix);
    }
    scene_.warn("lines_and_points_skipped", lines_and_points_,
                mesh::plural(lines_and_points_, "primitive") + " of lines or points");
    mesh::ReadMeshResult read = scene_.take();
    read.metres_per_unit = 1.0;
    read.up = mesh::UpAxis::kY;
    return read;
}

}  // namespace

Result<mesh::ReadMeshResult> read_gltf(std::string_view bytes, const mesh::ReadMeshOptions& caps,
                                       const AskForFile& ask) {
    const auto model = open_gltf(bytes, ask);
    if (!model) return model.error();
    return GltfReader(*model, caps).read();
}

}  // namespace ossuary::index
