// Feeds arbitrary bytes to the readers of volumes, and what they read to what makes it a surface.

#include <cstdint>
#include <string_view>

#include "engine/mesh/edge_table.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_surface.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using ossuary::fuzz::require;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    ossuary::voxel::VolumeOptions options;
    options.max_voxels = 1 << 18;
    options.unpack.max_bytes = 1 << 20;
    const auto read = ossuary::voxel::read_volume(bytes, "input", options);
    if (!read) {
        require(!read.error().message.empty());
        return 0;
    }
    require(read->voxel_count() <= options.max_voxels);
    require(read->values.size() == read->voxel_count() * size_of(read->type));
    const auto surface = ossuary::voxel::volume_surface(*read, {.max_side = 24});
    if (!surface) {
        require(surface.error().code == ossuary::ErrorCode::kSolidEmpty);
        return 0;
    }
    const ossuary::mesh::EdgeTable table = ossuary::mesh::build_edge_table(surface->mesh);
    for (const auto& edge : table.edges) require(edge.side_count % 2 == 0);
    return 0;
}
