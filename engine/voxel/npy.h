#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/voxel/bit_volume.h"
#include "engine/voxel/volume.h"

namespace ossuary::voxel {

struct NpyOptions {
    std::uint64_t max_voxels = std::uint64_t{1} << 30;  ///< 1024³
    std::int64_t max_side = 4096;
};

/// Reads a three-dimensional array of NumPy's .npy format (versions 1.0, 2.0, 3.0), C or Fortran
/// order, of type bool or (u)int8: every value but 0 is a set voxel. Array axis 0 is x, axis 1 is
/// y, axis 2 is z: array[x, y, z].
/// Errors: npy_invalid (what was found and what was expected), volume_too_large; read_npy also
/// file_not_found, file_unreadable.
Result<BitVolume> parse_npy(std::string_view bytes, std::string_view name,
                            const NpyOptions& options = {});
Result<BitVolume> read_npy(const std::filesystem::path& path, const NpyOptions& options = {});

/// The same with the values as they are, of integers and real numbers too. Voxels are of size 1 and
/// lie from the origin on. Errors: npy_invalid, volume_too_large.
Result<Volume> read_npy_volume(std::string_view bytes, std::string_view name,
                               const VolumeOptions& options = {}, const std::stop_token& stop = {});

/// The volume as version 1.0, uint8 (0 and 1), C order, array[x, y, z].
[[nodiscard]] std::string format_npy(const BitVolume& volume);
/// Errors: file_unwritable.
Result<void> write_npy(const BitVolume& volume, const std::filesystem::path& path);

}  // namespace ossuary::voxel
