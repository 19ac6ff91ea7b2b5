#include "engine/voxel/volume.h"

#include <cassert>
#include <cmath>

#include "engine/voxel/nifti_header.h"
#include "engine/voxel/npy.h"
#include "engine/voxel/volume_parts.h"

namespace ossuary::voxel {

std::size_t size_of(VoxelType type) {
    switch (type) {
        case VoxelType::kUint8:
        case VoxelType::kInt8:
            return 1;
        case VoxelType::kUint16:
        case VoxelType::kInt16:
            return 2;
        case VoxelType::kUint32:
        case VoxelType::kInt32:
        case VoxelType::kFloat32:
            return 4;
        case VoxelType::kUint64:
        case VoxelType::kInt64:
        case VoxelType::kFloat64:
            return 8;
    }
    assert(false);
    return 1;
}

Result<Vec3i> checked_size(const std::array<std::uint64_t, 3>& sides,
                           const VolumeOptions& options) {
    std::uint64_t voxels = 1;
    Vec3i size;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint64_t side = sides[axis];
        assert(side > 0);
        if (side > static_cast<std::uint64_t>(options.max_side) ||
            voxels > options.max_voxels / side) {
            return {ErrorCode::kVolumeTooLarge,
                    "expected at most " + std::to_string(options.max_side) + " voxels a side and " +
                        std::to_string(options.max_voxels) + " in all, found " +
                        std::to_string(sides[0]) + " x " + std::to_string(sides[1]) + " x " +
                        std::to_string(sides[2])};
        }
        voxels *= side;
        size[static_cast<Eigen::Index>(axis)] = static_cast<int>(side);
    }
    return size;
}

std::string size_text(const Vec3i& size) {
    return std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " +
           std::to_string(size.z());
}

bool is_usable_frame(const Vec3& origin, const Mat3& axes) {
    if (!origin.allFinite() || !axes.allFinite()) return false;
    const double lengths = axes.col(0).norm() * axes.col(1).norm() * axes.col(2).norm();
    constexpr double kFlat = 1e-9;
    return lengths > 0 && std::isfinite(lengths) && std::abs(axes.determinant()) > kFlat * lengths;
}

namespace {

using Reader = Result<Volume> (*)(std::string_view, std::string_view, const VolumeOptions&,
                                  const std::stop_token&);

Reader reader_of(std::string_view bytes) {
    if (bytes.starts_with("NRRD000")) return read_nrrd;
    if (bytes.starts_with("\x93NUMPY")) return read_npy_volume;
    if (bytes.starts_with("#binvox")) return read_binvox;
    return looks_like_nifti(bytes) ? read_nifti : nullptr;
}

}  // namespace

bool looks_like_volume(std::string_view bytes) { return reader_of(bytes) != nullptr; }

Result<Volume> read_volume(std::string_view bytes, std::string_view name,
                           const VolumeOptions& options, const std::stop_token& stop) {
    const Reader reader = reader_of(bytes);
    if (reader != nullptr) return reader(bytes, name, options, stop);
    return {ErrorCode::kFormatUnknown,
            std::string(name) + ": expected a volume (NRRD, NIfTI-1, binvox, .npy)"};
}

}  // namespace ossuary::voxel
