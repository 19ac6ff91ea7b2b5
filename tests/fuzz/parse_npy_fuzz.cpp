// Feeds arbitrary bytes to the reader of NumPy volumes.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/voxel/npy.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using ossuary::fuzz::require;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto parsed = ossuary::voxel::parse_npy(bytes, "input");
    if (!parsed) {
        require(parsed.error().code == ossuary::ErrorCode::kNpyInvalid ||
                parsed.error().code == ossuary::ErrorCode::kVolumeTooLarge);
        return 0;
    }
    // As many voxels as bytes follow the header, whatever it says.
    require(parsed->voxel_count() <= size);
    const auto again = ossuary::voxel::parse_npy(ossuary::voxel::format_npy(*parsed), "written");
    require(again.ok() && *again == *parsed);
    return 0;
}
