#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>

#include "engine/core/geometry.h"
#include "engine/core/inflate.h"
#include "engine/core/result.h"
#include "engine/core/whole_file.h"

namespace ossuary::voxel {

enum class VoxelType : std::uint8_t {
    kUint8,
    kInt8,
    kUint16,
    kInt16,
    kUint32,
    kInt32,
    kUint64,
    kInt64,
    kFloat32,
    kFloat64
};

/// Bytes of a value in a file.
[[nodiscard]] std::size_t size_of(VoxelType type);

/// Values on a grid as a file holds them, and where they lie.
struct Volume {
    Vec3i size = Vec3i::Zero();  ///< each side at least 1
    VoxelType type = VoxelType::kUint8;
    std::endian order = std::endian::little;
    bool last_axis_fastest = false;  ///< z fastest, then y, then x; else x fastest
    /// As many values as there are voxels: bytes of the file, or of `unpacked`.
    std::string_view values;
    WholeFile unpacked;
    /// What a stored value stands for: slope * value + intercept.
    double slope = 1.0;
    double intercept = 0.0;
    Vec3 origin = Vec3::Zero();    ///< middle of the voxel (0, 0, 0), world units
    Mat3 axes = Mat3::Identity();  ///< steps from voxel to voxel as columns; may mirror
    std::string unit;              ///< m, mm, um; empty where the file does not say

    [[nodiscard]] std::uint64_t voxel_count() const {
        return static_cast<std::uint64_t>(size.x()) * static_cast<std::uint64_t>(size.y()) *
               static_cast<std::uint64_t>(size.z());
    }
};

/// Caps that keep a hostile or broken file from taking the machine.
struct VolumeOptions {
    std::uint64_t max_voxels = std::uint64_t{1} << 28;
    std::int64_t max_side = 4096;
    UnpackCaps unpack;
};

/// Whether a file holds a volume of one of the formats below, by its first bytes.
[[nodiscard]] bool looks_like_volume(std::string_view bytes);

/// Reads a volume, whatever its format; `name` stands for the file in messages, which say where in
/// it and what was expected. `bytes` must outlive the result.
/// Errors: those of the format; format_unknown.
Result<Volume> read_volume(std::string_view bytes, std::string_view name,
                           const VolumeOptions& options = {}, const std::stop_token& stop = {});
/// Not of bytes that would go before what is read of them.
template <typename Bytes>
requires std::same_as<Bytes, std::string> Result<Volume> read_volume(
    Bytes&& bytes, std::string_view name, const VolumeOptions& options = {},
    const std::stop_token& stop = {})
= delete;

/// Nearly Raw Raster Data (teem's definition, NRRD0001 to NRRD0005): three axes, others of one
/// sample; types from int8 to double; encodings raw, ascii and gzip; `spacings`, or `space
/// directions` and `space origin`; `space units`; `line skip` and `byte skip`.
/// Errors: nrrd_invalid (with the line), volume_detached (the values lie in another file, which
/// is named), volume_too_large, those of gunzip, cancelled.
Result<Volume> read_nrrd(std::string_view bytes, std::string_view name,
                         const VolumeOptions& options = {}, const std::stop_token& stop = {});

/// NIfTI-1 in one file (Cox et al., 2004), in either byte order: three axes, others of one sample;
/// integers and floats with slope and intercept; placed by sform, else qform, else by the spacing.
/// Errors: nifti_invalid (with the byte), format_unsupported (NIfTI-2), volume_too_large.
Result<Volume> read_nifti(std::string_view bytes, std::string_view name,
                          const VolumeOptions& options = {}, const std::stop_token& stop = {});

/// Patrick Min's binvox, version 1: runs of set and clear voxels, `translate` and `scale`.
/// Errors: binvox_invalid (with the line or the byte), volume_too_large, cancelled.
Result<Volume> read_binvox(std::string_view bytes, std::string_view name,
                           const VolumeOptions& options = {}, const std::stop_token& stop = {});

// NumPy's arrays: read_npy_volume in npy.h.

}  // namespace ossuary::voxel
