#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/voxel/volume.h"

namespace ossuary::voxel {

enum class NrrdEncoding { kRaw, kText, kGzip };

/// What a NRRD file says of itself before its data.
struct NrrdHeader {
    std::array<std::uint64_t, 3> sides{};
    VoxelType type = VoxelType::kUint8;
    std::endian order = std::endian::little;
    NrrdEncoding encoding = NrrdEncoding::kRaw;
    std::uint64_t line_skip = 0;
    std::int64_t byte_skip = 0;  ///< -1: the values are the file's last bytes
    Vec3 origin = Vec3::Zero();
    Mat3 axes = Mat3::Identity();
    std::string unit;
    std::size_t bytes = 0;  ///< up to the data
};

/// Reads a header up to the empty line after it. Messages name the line, not the file.
/// Errors: nrrd_invalid, volume_detached (the values lie in another file, which is named).
Result<NrrdHeader> read_nrrd_header(std::string_view bytes);

}  // namespace ossuary::voxel
