#include "engine/skeleton/surface_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ossuary::skeleton {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();
constexpr double kPlacesPerVoxel = 1024.0;

using Place = Eigen::Matrix<std::int64_t, 3, 1>;

std::size_t hash_of_place(const Place& place) {
    std::uint64_t hash = 0;
    for (const std::int64_t coordinate : place) {
        hash = (hash ^ static_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

bool comes_before(const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

std::vector<Vec3> surface_points(const mesh::TriangleMesh& mesh,
                                 const WorldFromGrid& world_from_grid) {
    std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) used[v] = 1;
    }
    std::vector<Vec3> points;
    std::vector<Place> places;
    std::vector<std::uint32_t> table(std::bit_ceil(2 * mesh.vertices.size() + 1), kNoPoint);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (used[v] == 0) continue;
        const Vec3 point = world_from_grid.grid(mesh.vertices[v]);
        const Place place = (kPlacesPerVoxel * point).array().round().cast<std::int64_t>();
        std::size_t slot = hash_of_place(place) & (table.size() - 1);
        while (table[slot] != kNoPoint && places[table[slot]] != place) {
            slot = (slot + 1) & (table.size() - 1);
        }
        if (table[slot] == kNoPoint) {
            table[slot] = static_cast<std::uint32_t>(points.size());
            points.push_back(point);
            places.push_back(place);
        } else if (comes_before(point, points[table[slot]])) {
            points[table[slot]] = point;
        }
    }
    return points;
}

}  // namespace ossuary::skeleton
