// The blob of a surface's local features.

#include <algorithm>
#include <cmath>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/codec.h"

namespace ossuary::index {

namespace {

using registration::LocalFeature;

constexpr double kNormalSteps = 127.0;

void put_vector(ByteWriter& writer, const Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) writer.put(vector[axis]);
}

Vec3 get_vector(ByteReader& reader) {
    Vec3 vector;
    for (int axis = 0; axis < 3; ++axis) vector[axis] = reader.get<double>();
    return vector;
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

}  // namespace

std::string encode_features(const registration::WholeFeatures& whole) {
    const registration::LocalFeatures& features = whole.features;
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(features.points.size()));
    writer.put(static_cast<std::uint32_t>(features.radii.size()));
    writer.put(static_cast<std::uint32_t>(LocalFeature::kBytes));
    writer.put(whole.area);
    for (const double radius : features.radii) writer.put(radius);
    for (const Vec3& point : features.points) put_vector(writer, point);
    for (const Vec3& normal : features.normals) {
        for (int axis = 0; axis < 3; ++axis) {
            writer.put(static_cast<std::int8_t>(std::lround(kNormalSteps * normal[axis])));
        }
    }
    for (const LocalFeature& feature : features.features) {
        writer.put_raw({reinterpret_cast<const char*>(feature.values.data()), LocalFeature::kBytes});
    }
    return seal_blob(kFeaturesBlob, writer.bytes());
}

Result<registration::WholeFeatures> decode_features(std::string_view blob) {
    const auto payload = open_blob(kFeaturesBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    registration::WholeFeatures whole;
    registration::LocalFeatures& features = whole.features;
    const std::uint32_t points = reader.get_count(27);
    const std::uint32_t radii = reader.get_count(8);
    if (reader.get<std::uint32_t>() != LocalFeature::kBytes) {
        return corrupt_blob(kFeaturesBlob, "features of another length");
    }
    whole.area = reader.get<double>();
    features.radii = reader.get_all<double>(radii);
    for (std::uint32_t i = 0; i < points; ++i) {
        features.points.emplace_back(get_vector(reader));
    }
    for (std::uint32_t i = 0; i < points; ++i) {
        Vec3 normal;
        for (int axis = 0; axis < 3; ++axis) normal[axis] = reader.get<std::int8_t>() / kNormalSteps;
        features.normals.push_back(normal);
    }
    for (std::uint64_t i = 0; i < std::uint64_t{points} * radii && reader.ok(); ++i) {
        const std::string_view values = reader.get_raw(LocalFeature::kBytes);
        if (!reader.ok()) break;
        LocalFeature feature;
        std::copy(values.begin(), values.end(), feature.values.begin());
        features.features.push_back(feature);
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kFeaturesBlob, "wrong length");
    const std::string_view fault = fault_of(whole);
    if (!fault.empty()) return corrupt_blob(kFeaturesBlob, fault);
    return whole;
}

}  // namespace ossuary::index
