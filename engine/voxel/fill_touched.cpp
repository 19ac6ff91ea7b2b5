#include "engine/voxel/fill_touched.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace ossuary::voxel {
namespace {

constexpr int kBlockBits = 3;
constexpr int kBlock = 1 << kBlockBits;
/// Places on a triangle are at most this far apart along each axis.
constexpr std::int32_t kSpacing = kGridOne / 2;

/// Which blocks of 8x8x8 voxels have voxels of the bounding box that are not set yet.
class OpenBlocks {
public:
    explicit OpenBlocks(const GridMesh& mesh)
        : size_((mesh.size.array() + (kBlock - 1)) / kBlock),
          clear_(static_cast<std::size_t>(size_.prod()), 0),
          sums_(static_cast<std::size_t>((size_.array() + 1).prod()), 0) {
        for (int z = mesh.low.z(); z < mesh.high.z(); ++z) {
            for (int y = mesh.low.y(); y < mesh.high.y(); ++y) {
                for (int x = mesh.low.x(); x < mesh.high.x(); ++x) ++clear_[block_of({x, y, z})];
            }
        }
        sum_up();
    }

    void fill(const Vec3i& voxel) { closed_ += --clear_[block_of(voxel)] == 0 ? 1 : 0; }

    /// Whether a voxel of [low, high] may not be set yet.
    [[nodiscard]] bool any(const Vec3i& low, const Vec3i& high) const {
        const Vec3i a = low / kBlock;
        const Vec3i b = high / kBlock + Vec3i::Ones();
        return sum(b.x(), b.y(), b.z()) - sum(a.x(), b.y(), b.z()) - sum(b.x(), a.y(), b.z()) -
                   sum(b.x(), b.y(), a.z()) + sum(a.x(), a.y(), b.z()) + sum(a.x(), b.y(), a.z()) +
                   sum(b.x(), a.y(), a.z()) - sum(a.x(), a.y(), a.z()) !=
               0;
    }

    /// Takes notice of the blocks that have been filled, every so many calls.
    void refresh() {
        constexpr int kCalls = 1024;
        if (++calls_ < kCalls) return;
        calls_ = 0;
        if (closed_ > 0) sum_up();
    }

private:
    [[nodiscard]] std::size_t block_of(const Vec3i& v) const {
        return (static_cast<std::size_t>(v.z() >> kBlockBits) *
                    static_cast<std::size_t>(size_.y()) +
                static_cast<std::size_t>(v.y() >> kBlockBits)) *
                   static_cast<std::size_t>(size_.x()) +
               static_cast<std::size_t>(v.x() >> kBlockBits);
    }
    [[nodiscard]] std::size_t place(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y() + 1) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size_.x() + 1) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::int64_t sum(int x, int y, int z) const { return sums_[place(x, y, z)]; }

    /// sums_ at (x, y, z): the open blocks before it along every axis.
    void sum_up() {
        closed_ = 0;
        std::size_t block = 0;
        for (int z = 0; z < size_.z(); ++z) {
            for (int y = 0; y < size_.y(); ++y) {
                std::int32_t row = 0;
                for (int x = 0; x < size_.x(); ++x) {
                    row += clear_[block++] > 0 ? 1 : 0;
                    sums_[place(x + 1, y + 1, z + 1)] = row + sums_[place(x + 1, y, z + 1)] +
                                                        sums_[place(x + 1, y + 1, z)] -
                                                        sums_[place(x + 1, y, z)];
                }
            }
        }
    }

    Vec3i size_;
    std::vector<std::uint16_t> clear_;  ///< voxels of each block
    std::vector<std::int32_t> sums_;
    int calls_ = 0, closed_ = 0;
};

std::int32_t farthest_along(const GridPoint& a, const GridPoint& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

std::int32_t steps_over(std::int32_t length) {
    return std::max((length + kSpacing - 1) / kSpacing, 1);
}

class TrianglePainter {
public:
    TrianglePainter(const GridMesh& mesh, BitVolume& volume)
        : mesh_(mesh), volume_(volume), open_(mesh) {}

    /// Returns the number of places looked at.
    std::uint64_t add(std::array<GridPoint, 3> p) {
        open_.refresh();
        Vec3i low = mesh_.voxel_of(p[0]), high = low;
        for (const GridPoint& point : p) {
            low = low.cwiseMin(mesh_.voxel_of(point));
            high = high.cwiseMax(mesh_.voxel_of(point));
        }
        if (!open_.any(low, high)) return 1;
        // In an order of their own, so that places do not depend on the order of the corners; then
        // the longest side first.
        std::sort(p.begin(), p.end());
        if (farthest_along(p[0], p[1]) < farthest_along(p[1], p[2])) std::swap(p[0], p[2]);
        if (farthest_along(p[0], p[1]) < farthest_along(p[0], p[2])) std::swap(p[1], p[2]);
        const std::int32_t rows = steps_over(height_over_base(p));
        std::uint64_t work = 1;
        for (std::int32_t row = 0; row <= rows; ++row) {
            work += paint_row(between(p[0], p[2], row, rows), between(p[1], p[2], row, rows));
        }
        return work;
    }

private:
    /// Of p[2] over the line through p[0] and p[1].
    static std::int32_t height_over_base(const std::array<GridPoint, 3>& p) {
        const auto vector = [](const GridPoint& a, const GridPoint& b) {
            return Vec3(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        };
        const Vec3 base = vector(p[0], p[1]);
        const double length = base.norm();
        if (!(length > 0)) return 0;
        const double height = base.cross(vector(p[0], p[2])).norm() / length;
        return static_cast<std::int32_t>(std::ceil(height));
    }

    static GridPoint between(const GridPoint& a, const GridPoint& b, std::int32_t i,
                             std::int32_t steps) {
        GridPoint result;
        for (std::size_t x = 0; x < 3; ++x) {
            result[x] = a[x] + static_cast<std::int32_t>(std::int64_t{b[x] - a[x]} * i / steps);
        }
        return result;
    }

    std::uint64_t paint_row(const GridPoint& a, const GridPoint& b) {
        const std::int32_t steps = steps_over(farthest_along(a, b));
        // Sixteen more bits, so that the steps' rounding does not add up.
        constexpr int kMore = 16;
        std::array<std::int64_t, 3> at, step;
        for (std::size_t x = 0; x < 3; ++x) {
            at[x] = std::int64_t{a[x]} << kMore;
            step[x] = (std::int64_t{b[x] - a[x]} << kMore) / steps;
        }
        for (std::int32_t i = 0; i <= steps; ++i) {
            set({static_cast<std::int32_t>(at[0] >> kMore),
                 static_cast<std::int32_t>(at[1] >> kMore),
                 static_cast<std::int32_t>(at[2] >> kMore)});
            for (std::size_t x = 0; x < 3; ++x) at[x] += step[x];
        }
        return static_cast<std::uint64_t>(steps) + 1;
    }

    void set(const GridPoint& point) {
        const Vec3i voxel = mesh_.voxel_of(point);
        if (volume_.test(voxel)) return;
        volume_.set(voxel);
        open_.fill(voxel);
    }

    const GridMesh& mesh_;
    BitVolume& volume_;
    OpenBlocks open_;
};

/// Of a triangle, whichever way its corners are numbered.
std::uint64_t shuffled_place(std::array<GridPoint, 3> p) {
    std::sort(p.begin(), p.end());
    std::uint64_t hash = 0x9E3779B97F4A7C15u;
    for (const GridPoint& point : p) {
        for (const std::int32_t coordinate : point) {
            hash = (hash ^ static_cast<std::uint32_t>(coordinate)) * 0xBF58476D1CE4E5B9u;
            hash ^= hash >> 31;
        }
    }
    return hash;
}

/// Every triangle, and every collapsed one as one of two equal corners, in a shuffled order.
std::vector<std::array<std::uint32_t, 3>> shuffled_triangles(const GridMesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> triangles = mesh.triangles;
    for (const auto& [a, b] : mesh.collapsed) triangles.push_back({a, b, b});
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        order.emplace_back(shuffled_place({mesh.points[a], mesh.points[b], mesh.points[c]}), t);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::array<std::uint32_t, 3>> shuffled;
    shuffled.reserve(order.size());
    for (const auto& [ignored, t] : order) shuffled.push_back(triangles[t]);
    return shuffled;
}

}  // namespace

TouchedSurface fill_touched(const GridMesh& mesh, std::uint64_t most_work,
                            const std::stop_token& stop, BitVolume& volume) {
    TouchedSurface result;
    TrianglePainter painter(mesh, volume);
    constexpr std::uint64_t kBetweenLooks = 1 << 16;
    std::uint64_t next_look = kBetweenLooks;
    for (const auto& [a, b, c] : shuffled_triangles(mesh)) {
        result.work += painter.add({mesh.points[a], mesh.points[b], mesh.points[c]});
        ++result.triangles;
        if (result.work < next_look) continue;
        next_look = result.work + kBetweenLooks;
        if (result.work > most_work || stop.stop_requested()) break;
    }
    return result;
}

}  // namespace ossuary::voxel
