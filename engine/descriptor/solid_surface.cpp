#include "engine/descriptor/solid_surface.h"

#include <array>
#include <cmath>

#include "engine/voxel/border.h"

namespace ossuary::descriptor {
namespace {

constexpr int kReach = 3;
constexpr int kWidth = 2 * kReach + 1;

/// The rows of the ball of radius kReach: dy, dz and half the length of the row.
struct BallRow {
    int dy = 0;
    int dz = 0;
    int half = 0;
};

std::vector<BallRow> ball_rows() {
    std::vector<BallRow> rows;
    for (int dz = -kReach; dz <= kReach; ++dz) {
        for (int dy = -kReach; dy <= kReach; ++dy) {
            const int rest = kReach * kReach + 1 - dy * dy - dz * dz;
            if (rest < 0) continue;
            rows.push_back({dy, dz, static_cast<int>(std::sqrt(static_cast<double>(rest)))});
        }
    }
    return rows;
}

/// For each pattern of kWidth bits their number and the sum of their offsets from the middle.
struct RowSums {
    std::array<std::int8_t, 1 << kWidth> count{};
    std::array<std::int8_t, 1 << kWidth> moment{};
    RowSums() {
        for (unsigned bits = 0; bits < count.size(); ++bits) {
            int n = 0, sum = 0;
            for (int i = 0; i < kWidth; ++i) {
                if ((bits >> i) & 1u) ++n, sum += i - kReach;
            }
            count[bits] = static_cast<std::int8_t>(n);
            moment[bits] = static_cast<std::int8_t>(sum);
        }
    }
};

/// The kWidth voxels around (x, y, z) along x as bits; 0 outside the volume.
unsigned row_bits(const voxel::BitVolume& solid, int x, int y, int z) {
    const Vec3i& size = solid.size();
    if (y < 0 || z < 0 || y >= size.y() || z >= size.z()) return 0;
    const auto row = solid.row(y, z);
    const int first = x - kReach;
    std::uint64_t bits = 0;
    if (first >= 0) {
        const auto word = static_cast<std::size_t>(first) >> 6;
        const unsigned shift = static_cast<unsigned>(first) & 63u;
        bits = row[word] >> shift;
        if (shift > 64 - kWidth && word + 1 < row.size()) bits |= row[word + 1] << (64 - shift);
    } else {
        bits = row[0] << -first;
    }
    return static_cast<unsigned>(bits) & ((1u << kWidth) - 1u);
}

int open_faces(const voxel::BitVolume& solid, const Vec3i& v) {
    int open = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
            Vec3i neighbor = v;
            neighbor[axis] += step;
            open += solid.test_or_false(neighbor) ? 0 : 1;
        }
    }
    return open;
}

}  // namespace

SolidSurface solid_surface(const voxel::BitVolume& solid) {
    static const std::vector<BallRow> kRows = ball_rows();
    static const RowSums kSums;
    SolidSurface surface;
    surface.voxels = voxel::border_points(solid);
    const std::size_t count = surface.voxels.size();
    surface.points.reserve(count);
    surface.normals.reserve(count);
    surface.areas.reserve(count);
    for (const Vec3i& v : surface.voxels) {
        Vec3i moment = Vec3i::Zero();
        for (const BallRow& row : kRows) {
            const unsigned mask = ((1u << (2 * row.half + 1)) - 1u) << (kReach - row.half);
            const unsigned bits = row_bits(solid, v.x(), v.y() + row.dy, v.z() + row.dz) & mask;
            const int n = kSums.count[bits];
            moment += Vec3i(kSums.moment[bits], n * row.dy, n * row.dz);
        }
        Vec3f normal = -moment.cast<float>();
        // A plate of one voxel is its own mirror image: any direction across it will do.
        normal = moment.isZero() ? Vec3f::UnitZ() : normal.normalized().eval();
        const float area = static_cast<float>(open_faces(solid, v)) / normal.lpNorm<1>();
        surface.points.push_back(v.cast<float>() + Vec3f::Constant(0.5F) + 0.5F * normal);
        surface.normals.push_back(normal);
        surface.areas.push_back(area);
        surface.total_area += static_cast<double>(area);
    }
    return surface;
}

voxel::BitVolume halve(const voxel::BitVolume& solid) {
    voxel::BitVolume half(((solid.size().array() + 1) / 2).matrix().eval());
    voxel::for_each_voxel(solid,
                          [&](const Vec3i& v) { half.set(v.x() / 2, v.y() / 2, v.z() / 2); });
    return half;
}

}  // namespace ossuary::descriptor
