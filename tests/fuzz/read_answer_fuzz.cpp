// Feeds arbitrary bytes to what takes meshes and members of archives from the reader process: the
// message first, up to a length in the first byte, then what its file holds.

#include <unistd.h>

#include <cstdint>
#include <string_view>

#include "index/reader/protocol.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ossuary;
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    const std::string_view message = bytes.substr(0, data[0]);
    (void)index::decode_fault(message);
    (void)index::decode_request(message);
    (void)index::decode_unpack(message);
    const auto file = index::memory_file(bytes.substr(message.size()));
    fuzz::require(file.ok());
    if (const auto members = index::read_members(message, file->get())) {
        for (const index::ArchiveMember& member : *members) {
            fuzz::require(!member.name.empty() && member.name.size() <= index::kLongestMember);
        }
    }
    constexpr std::uint64_t kMost = 10'000;
    const auto unpacked = index::read_unpacked(message, file->get(), kMost);
    fuzz::require(!unpacked || unpacked->size() <= kMost);
    mesh::ReadMeshOptions caps;
    caps.max_vertices = caps.max_faces = caps.max_triangles = 10'000;
    const auto read = index::read_answer(message, file->get(), caps);
    if (!read) return 0;
    fuzz::require(read->mesh.face_of_triangle.size() == read->mesh.triangles.size());
    for (const auto& triangle : read->mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            fuzz::require(vertex < read->mesh.vertices.size());
        }
    }
    for (const Vec3& vertex : read->mesh.vertices) fuzz::require(vertex.allFinite());
    return 0;
}
