#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "engine/core/named.h"
#include "engine/mesh/load_number.h"
#include "engine/voxel/nifti_header.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_parts.h"

namespace ossuary::voxel {
namespace {

constexpr std::size_t kNiftiHeader = 348;
constexpr std::int32_t kNifti2Header = 540;

/// The numbers of a header, by their place in it (nifti1.h).
class NiftiHeader {
public:
    NiftiHeader(std::string_view bytes, std::endian order) : bytes_(bytes), order_(order) {}

    template <typename T>
    [[nodiscard]] T number(std::size_t at) const {
        return mesh::load_number<T>(bytes_.data() + at, order_);
    }
    [[nodiscard]] double real(std::size_t at) const { return double{number<float>(at)}; }
    [[nodiscard]] int dimension(std::size_t axis) const {
        return number<std::int16_t>(40 + 2 * axis);
    }
    [[nodiscard]] double spacing(std::size_t axis) const { return real(76 + 4 * axis); }
    [[nodiscard]] std::endian order() const { return order_; }

private:
    std::string_view bytes_;
    std::endian order_;
};

std::optional<std::endian> order_of(std::string_view bytes) {
    if (bytes.size() < 4) return std::nullopt;
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const auto size = mesh::load_number<std::int32_t>(bytes.data(), order);
        if (size == static_cast<std::int32_t>(kNiftiHeader) || size == kNifti2Header) return order;
    }
    return std::nullopt;
}

std::optional<VoxelType> type_of(int code) {
    switch (code) {
        case 2:
            return VoxelType::kUint8;
        case 4:
            return VoxelType::kInt16;
        case 8:
            return VoxelType::kInt32;
        case 16:
            return VoxelType::kFloat32;
        case 64:
            return VoxelType::kFloat64;
        case 256:
            return VoxelType::kInt8;
        case 512:
            return VoxelType::kUint16;
        case 768:
            return VoxelType::kUint32;
        case 1024:
            return VoxelType::kInt64;
        case 1280:
            return VoxelType::kUint64;
        default:
            return std::nullopt;
    }
}

Error invalid_nifti(std::size_t byte, const std::string& what) {
    return {ErrorCode::kNiftiInvalid, "byte " + std::to_string(byte) + ": " + what};
}

/// The frame by the matrix of the header (method 3).
void place_by_sform(const NiftiHeader& header, Volume& volume) {
    for (int row = 0; row < 3; ++row) {
        const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
        for (int column = 0; column < 3; ++column) {
            volume.axes(row, column) = header.real(at + 4 * static_cast<std::size_t>(column));
        }
        volume.origin[row] = header.real(at + 12);
    }
}

/// The frame by the quaternion of the header (method 2); pixdim[0] below 0 mirrors z.
void place_by_qform(const NiftiHeader& header, Volume& volume) {
    const double b = header.real(256), c = header.real(260), d = header.real(264);
    const double a = std::sqrt(std::max(0.0, 1.0 - (b * b + c * c + d * d)));
    const Mat3 rotation = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix();
    const double turn = header.spacing(0) < 0 ? -1.0 : 1.0;
    const Vec3 steps(header.spacing(1), header.spacing(2), turn * header.spacing(3));
    volume.axes = rotation * steps.asDiagonal();
    volume.origin = Vec3(header.real(268), header.real(272), header.real(276));
}

/// The first of the three methods that the header has and that spans space.
Result<void> place(const NiftiHeader& header, Volume& volume) {
    if (header.number<std::int16_t>(254) > 0) {
        place_by_sform(header, volume);
        if (is_usable_frame(volume.origin, volume.axes)) return {};
    }
    if (header.number<std::int16_t>(252) > 0) {
        place_by_qform(header, volume);
        if (is_usable_frame(volume.origin, volume.axes)) return {};
    }
    const Vec3 steps(header.spacing(1), header.spacing(2), header.spacing(3));
    volume.origin = Vec3::Zero();
    volume.axes = steps.cwiseAbs().asDiagonal();
    if (is_usable_frame(volume.origin, volume.axes)) return {};
    return invalid_nifti(76, "expected a spacing above 0 along each axis");
}

Result<std::array<std::uint64_t, 3>> sides_of(const NiftiHeader& header) {
    const int dimensions = header.dimension(0);
    if (dimensions < 3 || dimensions > 7) {
        return invalid_nifti(40, "expected 3 axes, found " + std::to_string(dimensions));
    }
    std::array<std::uint64_t, 3> sides{};
    for (std::size_t axis = 1; axis <= static_cast<std::size_t>(dimensions); ++axis) {
        const int side = header.dimension(axis);
        const bool right = axis <= 3 ? side > 0 : side == 1;
        if (!right) {
            return invalid_nifti(40 + 2 * axis, "axis " + std::to_string(axis) + ": expected " +
                                                    (axis <= 3 ? "a sample or more" : "1 sample") +
                                                    ", found " + std::to_string(side));
        }
        if (axis <= 3) sides[axis - 1] = static_cast<std::uint64_t>(side);
    }
    return sides;
}

/// How far into the file the values begin.
Result<std::size_t> data_start(const NiftiHeader& header, std::size_t file_size) {
    const double offset = header.real(108);
    if (offset >= static_cast<double>(kNiftiHeader) && offset == std::floor(offset) &&
        offset <= static_cast<double>(file_size)) {
        return static_cast<std::size_t>(offset);
    }
    // Some programs leave it out: the values follow the header and its four bytes of extension.
    if (offset == 0) return std::min(kNiftiHeader + 4, file_size);
    return invalid_nifti(108, "expected where the values begin, found a place outside of the file");
}

std::string unit_of(const NiftiHeader& header) {
    switch (header.number<std::uint8_t>(123) & 7) {
        case 1:
            return "m";
        case 2:
            return "mm";
        case 3:
            return "um";
        default:
            return {};
    }
}

Result<Volume> read_nifti_bytes(std::string_view bytes, const VolumeOptions& options) {
    const std::optional<std::endian> order = order_of(bytes);
    if (!order || bytes.size() < kNiftiHeader) {
        return invalid_nifti(0, "expected a header of 348 bytes");
    }
    const NiftiHeader header(bytes, *order);
    if (header.number<std::int32_t>(0) == kNifti2Header) {
        return Error{ErrorCode::kFormatUnsupported, "byte 0: expected NIfTI-1, found NIfTI-2"};
    }
    if (bytes.substr(344, 3) == "ni1") {
        return invalid_nifti(344, "expected header and values in one file, found a header alone");
    }
    const auto sides = sides_of(header);
    if (!sides) return sides.error();
    const Result<Vec3i> size = checked_size(*sides, options);
    if (!size) return size.error();
    Volume volume;
    volume.size = *size;
    const int code = header.number<std::int16_t>(70);
    const std::optional<VoxelType> type = type_of(code);
    if (!type) {
        return invalid_nifti(70, "expected one integer or real number a voxel, found data type " +
                                     std::to_string(code));
    }
    volume.type = *type;
    volume.order = *order;
    const Result<std::size_t> start = data_start(header, bytes.size());
    if (!start) return start.error();
    const std::uint64_t expected = volume.voxel_count() * size_of(volume.type);
    volume.values = bytes.substr(*start);
    if (volume.values.size() < expected) {
        return invalid_nifti(*start, "expected " + std::to_string(expected) + " bytes for " +
                                         size_text(*size) + " voxels, found " +
                                         std::to_string(volume.values.size()));
    }
    volume.values = volume.values.substr(0, expected);
    const double slope = header.real(112), intercept = header.real(116);
    if (slope != 0 && std::isfinite(slope) && std::isfinite(intercept)) {
        volume.slope = slope;
        volume.intercept = intercept;
    }
    volume.unit = unit_of(header);
    if (Result<void> placed = place(header, volume); !placed) return placed.error();
    return volume;
}

}  // namespace

bool looks_like_nifti(std::string_view bytes) {
    if (!order_of(bytes)) return false;
    if (bytes.substr(4, 4) == std::string_view("n+2\0", 4)) return true;
    return bytes.size() >= kNiftiHeader && (bytes.substr(344, 4) == std::string_view("n+1\0", 4) ||
                                            bytes.substr(344, 4) == std::string_view("ni1\0", 4));
}

Result<Volume> read_nifti(std::string_view bytes, std::string_view name,
                          const VolumeOptions& options, const std::stop_token&) {
    return named(name, read_nifti_bytes(bytes, options));
}

}  // namespace ossuary::voxel
