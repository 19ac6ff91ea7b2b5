#pragma once

#include <tiny_gltf.h>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"

namespace ossuary::index {

/// The numbers in a document's buffers. Every index, offset and count of the file is held against
/// what is there.
class GltfAccessors {
public:
    /// Both must outlive this.
    GltfAccessors(const tinygltf::Model& model, const mesh::ReadMeshOptions& caps)
        : model_(model), caps_(caps) {}

    /// Positions as the accessor says: any component type, normalised or not, sparse or not, zeros
    /// where it has no view. Errors: gltf_invalid, model_too_many_vertices.
    Result<std::vector<Vec3>> positions(int accessor);
    /// Errors: gltf_invalid, model_too_many_faces.
    Result<std::vector<std::uint32_t>> indices(int accessor);
    /// Linear colours, integers as normalised ones; of as many vertices.
    /// Errors: gltf_invalid.
    Result<std::vector<std::array<float, 3>>> colours(int accessor, std::size_t vertices);
    /// The bytes of a view, decoded where it is compressed (EXT_meshopt_compression).
    /// Errors: gltf_invalid.
    Result<std::span<const unsigned char>> view(int number);

private:
    struct Layout;
    Result<const tinygltf::Accessor*> find(int number);
    Result<Layout> layout_of(const tinygltf::Accessor& accessor);
    Result<void> apply_sparse(const tinygltf::Accessor& accessor, int components,
                              std::vector<double>& values);
    Result<std::vector<double>> values(const tinygltf::Accessor& accessor, int components);
    Result<std::span<const unsigned char>> slice(int buffer, std::size_t offset,
                                                 std::size_t length);
    Result<std::span<const unsigned char>> decode(int number, const tinygltf::Value& compression);

    const tinygltf::Model& model_;
    const mesh::ReadMeshOptions& caps_;
    std::map<int, std::vector<unsigned char>> decoded_;  ///< compressed views, by number
};

}  // namespace ossuary::index
