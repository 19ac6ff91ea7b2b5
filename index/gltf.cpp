#include "index/gltf.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/mesh/measures.h"
#include "engine/mesh/vertex_normals.h"
#include "index/coloured_parts.h"
#include "index/json_text.h"

namespace ossuary::index {
namespace {

using nlohmann::json;

// The glTF 2.0 specification's numbers.
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

/// The document and the buffer that its accessors point into.
class GltfBuilder {
public:
    GltfBuilder() {
        document_["asset"] = {{"version", "2.0"}, {"generator", "ossuary"}};
        document_["bufferViews"] = json::array();
        document_["accessors"] = json::array();
    }

    [[nodiscard]] json& document() { return document_; }

    /// Appends values as an accessor of its own; returns its number. No target for 0.
    template <typename T>
    std::size_t add(const std::vector<T>& values, const char* type, std::size_t components,
                    int component_type, int target) {
        json view = {{"buffer", 0},
                     {"byteOffset", bytes_.size()},
                     {"byteLength", values.size() * sizeof(T)}};
        if (target != 0) view["target"] = target;
        document_["bufferViews"].push_back(std::move(view));
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        document_["accessors"].push_back({{"bufferView", document_["bufferViews"].size() - 1},
                                          {"componentType", component_type},
                                          {"count", values.size() / components},
                                          {"type", type}});
        return document_["accessors"].size() - 1;
    }

    std::string take() {
        document_["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
        std::string text = json_text(document_);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string glb;
        const auto word = [&](std::uint32_t value) {
            glb.append(std::bit_cast<std::array<char, 4>>(value).data(), 4);
        };
        word(0x46546C67);  // "glTF"
        word(2);
        word(static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + bytes_.size()));
        word(static_cast<std::uint32_t>(text.size()));
        word(0x4E4F534A);  // "JSON"
        glb += text;
        word(static_cast<std::uint32_t>(bytes_.size()));
        word(0x004E4942);  // "BIN"
        return glb + bytes_;
    }

private:
    json document_;
    std::string bytes_;
};

json add_attributes(const mesh::TriangleMesh& mesh, const Vec3& origin,
                    const decomposition::Rig& rig, GltfBuilder& builder) {
    std::vector<float> positions, normals, weights;
    std::vector<std::uint16_t> joints;
    const std::vector<Vec3> vertex_normal = mesh::vertex_normals(mesh);
    Eigen::Vector3f low = (mesh.vertices[0] - origin).cast<float>(), high = low;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Eigen::Vector3f p = (mesh.vertices[v] - origin).cast<float>();
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        const Vec3 normal = vertex_normal[v].isZero() ? Vec3::UnitZ() : vertex_normal[v];
        const Eigen::Vector3f n = normal.cast<float>().normalized();
        for (int axis = 0; axis < 3; ++axis) {
            positions.push_back(p[axis]);
            normals.push_back(n[axis]);
        }
        joints.insert(joints.end(), rig.weights[v].joints.begin(), rig.weights[v].joints.end());
        weights.insert(weights.end(), rig.weights[v].weights.begin(), rig.weights[v].weights.end());
    }
    const std::size_t position = builder.add(positions, "VEC3", 3, kFloat, kArrayBuffer);
    builder.document()["accessors"][position]["min"] = {low.x(), low.y(), low.z()};
    builder.document()["accessors"][position]["max"] = {high.x(), high.y(), high.z()};
    return {{"POSITION", position},
            {"NORMAL", builder.add(normals, "VEC3", 3, kFloat, kArrayBuffer)},
            {"JOINTS_0", builder.add(joints, "VEC4", 4, kUnsignedShort, kArrayBuffer)},
            {"WEIGHTS_0", builder.add(weights, "VEC4", 4, kFloat, kArrayBuffer)}};
}

/// A primitive and a material for each part.
void add_mesh(const mesh::TriangleMesh& mesh, const decomposition::Segmentation& segmentation,
              const json& attributes, GltfBuilder& builder) {
    std::vector<std::vector<std::uint32_t>> indices(segmentation.parts);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        auto& part = indices[segmentation.labels[t]];
        part.insert(part.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    json primitives = json::array(), materials = json::array();
    for (std::uint32_t part = 0; part < indices.size(); ++part) {
        const std::size_t accessor =
            builder.add(indices[part], "SCALAR", 1, kUnsignedInt, kElementArrayBuffer);
        primitives.push_back(
            {{"attributes", attributes}, {"indices", accessor}, {"material", part}});
        json colour = json::array();
        // Colours are given as seen (sRGB), factors are linear.
        for (const std::uint8_t channel : part_colour(part)) {
            colour.push_back(std::pow(channel / 255.0, 2.2));
        }
        colour.push_back(1.0);
        materials.push_back({{"name", "part " + std::to_string(part)},
                             {"extras", {{"part", part}}},
                             {"doubleSided", true},
                             {"pbrMetallicRoughness",
                              {{"baseColorFactor", std::move(colour)},
                               {"metallicFactor", 0.0},
                               {"roughnessFactor", 0.9}}}});
    }
    builder.document()["meshes"] = json::array({{{"primitives", std::move(primitives)}}});
    builder.document()["materials"] = std::move(materials);
}

std::string joint_name(const decomposition::Rig& rig, std::size_t k) {
    const decomposition::Rig::Joint& joint = rig.joints[k];
    if (joint.parent < 0) return "root";
    if (joint.branch >= 0) return "branch " + std::to_string(joint.branch);
    const std::int32_t held_by = rig.joints[static_cast<std::size_t>(joint.parent)].branch;
    return "tip of branch " + std::to_string(held_by);
}

json translation(const Vec3& offset) { return {offset.x(), offset.y(), offset.z()}; }

/// Joint k is node k; after them come the mesh's node and the one that holds the joints and carries
/// them to where the model lies.
void add_nodes(const decomposition::Rig& rig, const Vec3& origin, std::string_view name,
               GltfBuilder& builder) {
    json nodes = json::array(), joints = json::array();
    std::vector<float> inverse_binds;
    for (std::size_t k = 0; k < rig.joints.size(); ++k) {
        const decomposition::Rig::Joint& joint = rig.joints[k];
        const Vec3 held_at =
            joint.parent < 0 ? origin : rig.joints[static_cast<std::size_t>(joint.parent)].position;
        nodes.push_back(
            {{"name", joint_name(rig, k)}, {"translation", translation(joint.position - held_at)}});
        if (joint.branch >= 0) nodes.back()["extras"] = {{"branch", joint.branch}};
        if (joint.parent >= 0)
            nodes[static_cast<std::size_t>(joint.parent)]["children"].push_back(k);
        joints.push_back(k);
        const Vec3 to_joint = origin - joint.position;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                const double moved = column == 3 && row < 3 ? to_joint[row] : 0.0;
                inverse_binds.push_back(static_cast<float>(row == column ? 1.0 : moved));
            }
        }
    }
    nodes.push_back({{"name", std::string(name)}, {"mesh", 0}, {"skin", 0}});
    const std::size_t binds = builder.add(inverse_binds, "MAT4", 16, kFloat, 0);
    builder.document()["skins"] = json::array(
        {{{"joints", std::move(joints)}, {"inverseBindMatrices", binds}, {"skeleton", 0}}});
    nodes.push_back({{"name", "origin"}, {"translation", translation(origin)}, {"children", {0}}});
    builder.document()["scenes"] = json::array({{{"nodes", {nodes.size() - 2, nodes.size() - 1}}}});
    builder.document()["scene"] = 0;
    builder.document()["nodes"] = std::move(nodes);
}

}  // namespace

std::string to_glb(const mesh::TriangleMesh& mesh, const decomposition::Segmentation& segmentation,
                   const decomposition::Rig& rig, std::string_view name) {
    GltfBuilder builder;
    const Vec3 origin = mesh::measure(mesh).bounds.center();
    const json attributes = add_attributes(mesh, origin, rig, builder);
    add_mesh(mesh, segmentation, attributes, builder);
    add_nodes(rig, origin, name, builder);
    return builder.take();
}

}  // namespace ossuary::index
