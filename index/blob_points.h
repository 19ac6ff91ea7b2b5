#pragma once

#include "engine/core/geometry.h"
#include "index/bytes.h"

namespace ossuary::index {

/// x, y, z as 64-bit floats.
inline void put_point(ByteWriter& writer, const Vec3& point) {
    writer.put(point.x());
    writer.put(point.y());
    writer.put(point.z());
}

inline Vec3 get_point(ByteReader& reader) {
    const auto x = reader.get<double>();
    const auto y = reader.get<double>();
    const auto z = reader.get<double>();
    return {x, y, z};
}

}  // namespace ossuary::index
