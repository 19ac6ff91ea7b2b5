#include "index/reader/read_scene.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "index/reader/scene_builder.h"
#include "index/reader/scene_frame.h"

namespace ossuary::index {
namespace {

using Matrix4 = Eigen::Matrix4d;

/// A file system without files: whatever a document refers to is not there.
class NoFiles : public Assimp::IOSystem {
public:
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
    void Close(Assimp::IOStream*) override {}
};

const char* hint_for(mesh::ModelFormat format) {
    switch (format) {
        case mesh::ModelFormat::kCollada:
            return "dae";
        case mesh::ModelFormat::kX3d:
            return "x3d";
        case mesh::ModelFormat::kAmf:
            return "amf";
        default:
            return "fbx";
    }
}

void set_up(Assimp::Importer& importer) {
    importer.SetIOHandler(new NoFiles);  // which the importer owns
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    for (const char* unused :
         {AI_CONFIG_IMPORT_FBX_READ_TEXTURES, AI_CONFIG_IMPORT_FBX_READ_CAMERAS,
          AI_CONFIG_IMPORT_FBX_READ_LIGHTS, AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS}) {
        importer.SetPropertyBool(unused, false);
    }
}

Matrix4 matrix_of(const aiMatrix4x4& from) {
    Matrix4 matrix;
    for (unsigned int row = 0; row < 4; ++row) {
        for (unsigned int column = 0; column < 4; ++column) {
            matrix(row, column) = double{from[row][column]};
        }
    }
    return matrix;
}

/// What an FBX file says in its settings.
SceneFrame fbx_frame(const aiScene& scene) {
    constexpr double kCentimetre = 0.01;
    SceneFrame frame{kCentimetre, mesh::UpAxis::kY};
    if (scene.mMetaData == nullptr) return frame;
    double precise = 0.0;
    float rough = 0.0F;
    if (scene.mMetaData->Get("UnitScaleFactor", precise) && precise > 0.0) {
        frame.metres_per_unit = precise * kCentimetre;
    } else if (scene.mMetaData->Get("UnitScaleFactor", rough) && rough > 0.0F) {
        frame.metres_per_unit = double{rough} * kCentimetre;
    }
    std::int32_t axis = 1;
    if (scene.mMetaData->Get("UpAxis", axis) && axis >= 0 && axis <= 2) {
        frame.up = static_cast<mesh::UpAxis>(axis);
    }
    return frame;
}

SceneFrame frame_of(const aiScene& scene, std::string_view bytes, mesh::ModelFormat format) {
    switch (format) {
        case mesh::ModelFormat::kCollada:
            return collada_frame(bytes);
        case mesh::ModelFormat::kAmf:
            return amf_frame(bytes);
        case mesh::ModelFormat::kFbx:
            return fbx_frame(scene);
        default:
            return {1.0, mesh::UpAxis::kY};
    }
}

mesh::Colour colour_from(float red, float green, float blue) {
    mesh::Colour colour{};
    const std::array channels = {red, green, blue};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        const float whole = std::isfinite(channels[i]) ? std::clamp(channels[i], 0.0F, 1.0F) : 0.0F;
        colour[i] = static_cast<std::uint8_t>(std::lround(255.0F * whole));
    }
    return colour;
}

/// Diffuse, as these formats' programs show it; white where the file names no material, for which
/// assimp puts a grey one.
mesh::Colour material_colour(const aiScene& scene, unsigned int number) {
    constexpr mesh::Colour kWhite = {255, 255, 255};
    if (number >= scene.mNumMaterials || scene.mMaterials[number] == nullptr) return kWhite;
    const aiMaterial& material = *scene.mMaterials[number];
    aiString name;
    if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS &&
        std::string_view(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME) {
        return kWhite;
    }
    aiColor4D diffuse;
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) != AI_SUCCESS) return kWhite;
    return colour_from(diffuse.r, diffuse.g, diffuse.b);
}

class SceneReader {
public:
    SceneReader(const aiScene& scene, const mesh::ReadMeshOptions& caps)
        : scene_(scene), builder_(caps, SceneBuilder::Corners::kJoin) {}

    Result<mesh::ReadMeshResult> read(const Matrix4& root);

private:
    Result<void> add_node(const aiNode& node, const Matrix4& matrix);
    Result<void> add_mesh(const aiMesh& mesh, const Matrix4& matrix);
    void colour_face(const aiMesh& mesh, const aiFace& face, bool mirrored,
                     const mesh::Colour& material);

    const aiScene& scene_;
    SceneBuilder builder_;
    std::vector<std::uint32_t> corners_;
    std::vector<mesh::Colour> colours_;
    std::size_t lines_and_points_ = 0;
};

/// The face of `corners_`, by its vertices' colours, else its material's.
void SceneReader::colour_face(const aiMesh& mesh, const aiFace& face, bool mirrored,
                              const mesh::Colour& material) {
    if (!mesh.HasVertexColors(0)) return builder_.colour_face(material);
    colours_.clear();
    bool said = false;
    for (unsigned int i = 0; i < face.mNumIndices; ++i) {
        const aiColor4D& colour =
            mesh.mColors[0][face.mIndices[mirrored ? face.mNumIndices - 1 - i : i]];
        colours_.push_back(colour_from(colour.r, colour.g, colour.b));
        // Of AMF, assimp gives vertices without a colour a black one that cannot be seen.
        said = said || colour.a > 0.0F || !colour.IsBlack();
    }
    if (said) builder_.colour_face(corners_, colours_);
}

Result<void> SceneReader::add_mesh(const aiMesh& mesh, const Matrix4& matrix) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(mesh.mNumVertices);
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D& local = mesh.mVertices[v];
        const Vec3 placed =
            matrix.topLeftCorner<3, 3>() * Vec3(double{local.x}, double{local.y}, double{local.z}) +
            matrix.topRightCorner<3, 1>();
        const auto number = builder_.add_vertex(placed);
        if (!number) return number.error();
        numbers.push_back(*number);
    }
    const bool mirrored = matrix.topLeftCorner<3, 3>().determinant() < 0.0;
    const mesh::Colour material = material_colour(scene_, mesh.mMaterialIndex);
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices < 3) {
            ++lines_and_points_;
            continue;
        }
        corners_.clear();
        for (unsigned int i = 0; i < face.mNumIndices; ++i) {
            const unsigned int corner = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
            if (corner >= numbers.size()) {
                return {
                    ErrorCode::kSceneInvalid,
                    "expected corners that are vertices, found number " + std::to_string(corner)};
            }
            corners_.push_back(numbers[corner]);
        }
        if (auto added = builder_.add_face(corners_); !added) return added;
        colour_face(mesh, face, mirrored, material);
    }
    return {};
}

Result<void> SceneReader::add_node(const aiNode& node, const Matrix4& matrix) {
    if (node.mNumMeshes == 0) return {};
    builder_.begin_object(node.mName.C_Str());
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene_.mNumMeshes) {
            return {ErrorCode::kSceneInvalid,
                    "expected the mesh of a node, found number " + std::to_string(node.mMeshes[i])};
        }
        if (auto added = add_mesh(*scene_.mMeshes[node.mMeshes[i]], matrix); !added) return added;
    }
    builder_.end_object();
    return {};
}

Result<mesh::ReadMeshResult> SceneReader::read(const Matrix4& root) {
    std::vector<std::pair<const aiNode*, Matrix4>> waiting = {{scene_.mRootNode, root}};
    while (!waiting.empty()) {
        const auto [node, matrix] = waiting.back();
        waiting.pop_back();
        if (auto added = add_node(*node, matrix); !added) return added.error();
        for (unsigned int i = node->mNumChildren; i > 0; --i) {
            const aiNode* child = node->mChildren[i - 1];
            waiting.emplace_back(child, matrix * matrix_of(child->mTransformation));
        }
    }
    builder_.warn("lines_and_points_skipped", lines_and_points_,
                  mesh::plural(lines_and_points_, "line or point") + " beside the faces");
    return builder_.take();
}

}  // namespace

Result<mesh::ReadMeshResult> read_scene(std::string_view bytes, mesh::ModelFormat format,
                                        const mesh::ReadMeshOptions& caps) {
    // assimp takes what there is of an X3D file for the whole.
    if (format == mesh::ModelFormat::kX3d && bytes.rfind("</X3D") == std::string_view::npos) {
        return {ErrorCode::kSceneInvalid, "expected </X3D> at the end, found none"};
    }
    Assimp::Importer importer;
    set_up(importer);
    const aiScene* scene =
        importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint_for(format));
    if (scene == nullptr || scene->mRootNode == nullptr) {
        const std::string why = importer.GetErrorString();
        return {ErrorCode::kSceneInvalid,
                "expected a " + std::string(to_string(format)) +
                    " file, found one that cannot be used: " + why.substr(0, why.find('\n'))};
    }
    const SceneFrame frame = frame_of(*scene, bytes, format);
    Matrix4 root = matrix_of(scene->mRootNode->mTransformation);
    if (format == mesh::ModelFormat::kCollada) {
        // assimp turns lengths into metres there; they stay in the file's unit.
        root.leftCols<3>() /= double{static_cast<float>(frame.metres_per_unit)};
    }
    auto read = SceneReader(*scene, caps).read(root);
    if (!read) return read;
    read->metres_per_unit = frame.metres_per_unit;
    read->up = frame.up;
    return read;
}

}  // namespace ossuary::index
