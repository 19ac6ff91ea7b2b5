// The blob of a surface's local features.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "index/blob.h"
#include "index/blob_points.h"
#include "index/bytes.h"
#include "index/codec.h"
#include "index/packed_bytes.h"

namespace ossuary::index {

namespace {

using registration::LocalFeature;

constexpr double kNormalSteps = 127.0;
constexpr std::uint32_t kMostPoints = 4096;
constexpr std::uint32_t kMostRadii = 16;

/// Half-bytes, the first of two in the lower half.
class HalfBytes {
public:
    void put(std::uint8_t half) {
        if (odd_) {
            bytes_.back() = static_cast<char>(static_cast<std::uint8_t>(bytes_.back()) | half << 4);
        } else {
            bytes_ += static_cast<char>(half);
        }
        odd_ = !odd_;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    bool odd_ = false;
};

std::uint8_t half_byte(std::string_view bytes, std::size_t at) {
    const auto byte = static_cast<std::uint8_t>(bytes[at / 2]);
    return static_cast<std::uint8_t>(at % 2 == 0 ? byte & 15U : byte >> 4U);
}

/// What is wrong with the numbers, if anything.
std::string_view fault_of(const registration::WholeFeatures& whole) {
    const auto finite = [](const Vec3& vector) { return vector.allFinite(); };
    const auto& points = whole.features.points;
    if (!std::isfinite(whole.area) || whole.area < 0.0) return "an area that is none";
    if (!std::all_of(points.begin(), points.end(), finite)) return "numbers that are not finite";
    double below = 0.0;
    for (const double radius : whole.features.radii) {
        if (!(radius > below) || !std::isfinite(radius)) return "radii out of order";
        below = radius;
    }
    return {};
}

void put_points(ByteWriter& writer, const std::vector<Vec3>& points) {
    const Vec3 origin = points.empty() ? Vec3(Vec3::Zero()) : points.front();
    put_point(writer, origin);
    for (int axis = 0; axis < 3; ++axis) {
        for (const Vec3& point : points) {
            writer.put(static_cast<float>(point[axis] - origin[axis]));
        }
    }
}

std::vector<Vec3> get_points(ByteReader& reader, std::size_t count) {
    std::vector<Vec3> points(count, get_point(reader));
    for (int axis = 0; axis < 3; ++axis) {
        for (Vec3& point : points) point[axis] += reader.get<float>();
    }
    return points;
}

}  // namespace

std::string encode_features(const registration::WholeFeatures& whole) {
    const registration::LocalFeatures& features = whole.features;
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(features.points.size()));
    writer.put(static_cast<std::uint32_t>(features.radii.size()));
    writer.put(static_cast<std::uint32_t>(LocalFeature::kBytes));
    writer.put(whole.area);
    for (const double radius : features.radii) writer.put(radius);
    put_points(writer, features.points);
    for (int axis = 0; axis < 3; ++axis) {
        for (const Vec3& normal : features.normals) {
            writer.put(static_cast<std::int8_t>(std::lround(kNormalSteps * normal[axis])));
        }
    }
    HalfBytes levels;
    for (std::size_t value = 0; value < LocalFeature::kBytes; ++value) {
        for (const LocalFeature& feature : features.features) {
            levels.put(static_cast<std::uint8_t>(feature.values[value] / LocalFeature::kStep));
        }
    }
    writer.put_raw(levels.bytes());
    return seal_blob(kFeaturesBlob, pack_bytes(writer.bytes()));
}

Result<registration::WholeFeatures> decode_features(std::string_view blob) {
    const auto payload = open_blob(kFeaturesBlob, blob);
    if (!payload) return payload.error();
    const auto unpacked = unpack_bytes(*payload);
    if (!unpacked) return corrupt_blob(kFeaturesBlob, "packed bytes that cannot be unpacked");
    ByteReader reader(*unpacked);
    registration::WholeFeatures whole;
    registration::LocalFeatures& features = whole.features;
    const std::uint32_t points = reader.get_count(15);
    const std::uint32_t radii = reader.get_count(8);
    if (points > kMostPoints || radii > kMostRadii) {
        return corrupt_blob(kFeaturesBlob, "more features than any program writes");
    }
    if (reader.get<std::uint32_t>() != LocalFeature::kBytes) {
        return corrupt_blob(kFeaturesBlob, "features of another length");
    }
    whole.area = reader.get<double>();
    features.radii = reader.get_all<double>(radii);
    features.points = get_points(reader, points);
    features.normals.resize(points);
    for (int axis = 0; axis < 3; ++axis) {
        for (Vec3& normal : features.normals) {
            normal[axis] = reader.get<std::int8_t>() / kNormalSteps;
        }
    }
    const std::size_t count = std::size_t{points} * radii;
    const std::string_view levels = reader.get_raw((count * LocalFeature::kBytes + 1) / 2);
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kFeaturesBlob, "wrong length");
    features.features.resize(count);
    for (std::size_t value = 0; value < LocalFeature::kBytes; ++value) {
        for (std::size_t i = 0; i < count; ++i) {
            features.features[i].values[value] = static_cast<std::uint8_t>(
                half_byte(levels, value * count + i) * LocalFeature::kStep);
        }
    }
    const std::string_view fault = fault_of(whole);
    if (!fault.empty()) return corrupt_blob(kFeaturesBlob, fault);
    return whole;
}

}  // namespace ossuary::index
