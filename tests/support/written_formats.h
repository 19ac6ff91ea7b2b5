#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::test {

/// A mesh as a GLB of one node: floats, 32-bit indices.
std::string to_plain_glb(const mesh::TriangleMesh& mesh);

/// The same as glTF as text, whose numbers are in the file `buffer` with these bytes.
struct SeparateGltf {
    std::string document;
    std::string buffer;
};
SeparateGltf to_separate_gltf(const mesh::TriangleMesh& mesh, const std::string& buffer_name);

/// A volume of bytes as NRRD.
std::string to_nrrd(const Vec3i& size, const std::function<int(const Vec3i&)>& value);

/// The model part of a 3MF package, from its resources and the items of its build.
std::string three_mf_part(const std::string& resources, const std::string& build);

/// A mesh as the resources of such a part: object 1. As many digits as floats have.
std::string three_mf_object(const mesh::TriangleMesh& mesh);

/// A ZIP archive of these members (name and bytes), compressed. Throws where it cannot be written.
std::filesystem::path write_zip(const std::filesystem::path& path,
                                const std::vector<std::pair<std::string, std::string>>& members);

/// A 3MF package around a model part. Throws where it cannot be written.
std::filesystem::path write_three_mf(const std::filesystem::path& path, const std::string& part);

}  // namespace ossuary::test
