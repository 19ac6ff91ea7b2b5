#include "engine/voxel/grid_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "engine/voxel/boundary_sum.h"

namespace ossuary::voxel {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::size_t hash_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint64_t hash = a * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (hash >> 29) ^ b) * 0xBF58476D1CE4E5B9u;
    hash = (hash ^ (hash >> 32) ^ c) * 0x94D049BB133111EBu;
    return static_cast<std::size_t>(hash ^ (hash >> 31));
}

/// Numbers distinct triples in order of appearance, by open addressing.
class TripleTable {
public:
    explicit TripleTable(std::size_t capacity)
        : slots_(std::bit_ceil(2 * capacity + 1), kNone), mask_(slots_.size() - 1) {}

    /// The index in `known` of the equal triple, or kNone after entering known.size() for it.
    template <typename Triple>
    std::uint32_t find_or_enter(const Triple& triple, const std::vector<Triple>& known) {
        std::size_t slot =
            hash_of(static_cast<std::uint32_t>(triple[0]), static_cast<std::uint32_t>(triple[1]),
                    static_cast<std::uint32_t>(triple[2])) &
            mask_;
        while (slots_[slot] != kNone) {
            const Triple& other = known[slots_[slot]];
            if (other[0] == triple[0] && other[1] == triple[1] && other[2] == triple[2]) {
                return slots_[slot];
            }
            slot = (slot + 1) & mask_;
        }
        slots_[slot] = static_cast<std::uint32_t>(known.size());
        return kNone;
    }

private:
    std::vector<std::uint32_t> slots_;
    std::size_t mask_;
};

/// Whether some numbers come twice; may say so, once in 10^5 meshes, where none does.
class RepeatFinder {
public:
    explicit RepeatFinder(std::size_t capacity)
        : slots_(std::bit_ceil(2 * capacity + 2), 0), mask_(slots_.size() - 1) {}

    [[nodiscard]] bool found() const { return found_; }
    void add(std::uint64_t number) {
        const std::uint32_t mark = static_cast<std::uint32_t>(number >> 32) | 1u;
        std::size_t slot = static_cast<std::size_t>(number) & mask_;
        while (slots_[slot] != 0 && slots_[slot] != mark) slot = (slot + 1) & mask_;
        found_ = found_ || slots_[slot] == mark;
        slots_[slot] = mark;
    }

private:
    std::vector<std::uint32_t> slots_;
    std::size_t mask_;
    bool found_ = false;
};

bool is_orthonormal(const Mat3& m) {
    return m.allFinite() && (m * m.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-9;
}

/// The number of transpositions, mod 2, that sort the corners.
bool sorts_oddly(const GridMesh::Triangle& t) {
    return (t[0] > t[1]) != ((t[1] > t[2]) != (t[0] > t[2]));
}

/// Takes over the triangles by their welded corners. A triangle that comes twice is kept once;
/// when the copies face both ways (double-sided models), it gets a direction that depends on its
/// corners' positions only, and the parts' orientation is worked out later.
void take_triangles(const mesh::TriangleMesh& mesh, const std::vector<std::uint32_t>& point_of,
                    GridMesh& grid) {
    TripleTable table(mesh.triangles.size());
    std::vector<GridMesh::Triangle> sorted;
    sorted.reserve(mesh.triangles.size());
    grid.triangles.reserve(mesh.triangles.size());
    for (const auto& [i, j, k] : mesh.triangles) {
        const GridMesh::Triangle t = {point_of[i], point_of[j], point_of[k]};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
            grid.collapsed.push_back({t[0], t[0] == t[1] ? t[2] : t[1]});
            continue;
        }
        GridMesh::Triangle key = t;
        std::sort(key.begin(), key.end());
        const std::uint32_t known = table.find_or_enter(key, sorted);
        if (known == kNone) {
            sorted.push_back(key);
            grid.triangles.push_back(t);
            continue;
        }
        ++grid.repeated_triangles;
        GridMesh::Triangle& kept = grid.triangles[known];
        if (sorts_oddly(kept) == sorts_oddly(t)) continue;
        const auto by_position = [&](std::uint32_t a, std::uint32_t b) {
            return grid.points[a] < grid.points[b];
        };
        std::sort(kept.begin(), kept.end(), by_position);
    }
}

struct Connections {
    std::vector<std::uint8_t> used;  ///< for each vertex: stray ones may lie anywhere
    /// Every edge is run along as often one way as the other and no triangle comes twice: there is
    /// nothing to weld.
    bool closed = false;
};

Connections look_at_triangles(const mesh::TriangleMesh& mesh) {
    Connections result;
    result.used.assign(mesh.vertices.size(), 0);
    const std::vector<std::uint64_t> keys = point_keys(mesh.vertices.size());
    BoundarySum boundary;
    RepeatFinder repeats(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) result.used[v] = 1;
        repeats.add(boundary.add(t, keys));
    }
    result.closed = boundary.oriented == 0 && !repeats.found();
    return result;
}

/// To the nearest. @pre positive: std::lround is a call
std::int32_t rounded(double x) { return static_cast<std::int32_t>(x + 0.5); }

}  // namespace

Result<GridMesh> lay_into_grid(const mesh::TriangleMesh& mesh, const VoxelizeOptions& options) {
    if (options.resolution < 8 || options.resolution > 1024) {
        return {ErrorCode::kInvalidArgument,
                "resolution: found " + std::to_string(options.resolution) + ", expected 8 to 1024"};
    }
    if (!is_orthonormal(options.rotation)) {
        return {ErrorCode::kInvalidArgument, "rotation: expected an orthonormal matrix"};
    }
    if (mesh.empty()) return {ErrorCode::kMeshEmpty, "the mesh has no triangle"};

    const Connections connections = look_at_triangles(mesh);
    const std::vector<std::uint8_t>& used = connections.used;
    const bool turned = options.rotation != Mat3::Identity();
    const Mat3 grid_from_world = options.rotation.transpose();
    const auto laid = [&](const Vec3& v) -> Vec3 { return turned ? grid_from_world * v : v; };
    Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max = -min;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (used[v] == 0) continue;
        const Vec3 p = laid(mesh.vertices[v]);
        if (!p.allFinite()) {
            return {ErrorCode::kInvalidArgument,
                    "vertex " + std::to_string(v) + ": expected finite coordinates"};
        }
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    const Vec3 extent = max - min;
    const double voxel_size = extent.maxCoeff() / options.resolution;
    if (!std::isfinite(voxel_size)) {
        return {ErrorCode::kInvalidArgument, "the bounding box exceeds the range of coordinates"};
    }
    if (!(voxel_size >= std::numeric_limits<double>::min())) {
        return {ErrorCode::kMeshNoExtent, "all vertices of the mesh coincide"};
    }

    GridMesh grid;
    const Vec3 voxels = extent / voxel_size;
    const Vec3i cells = voxels.array().ceil().cast<int>().max(1).min(options.resolution);
    grid.low = Vec3i::Constant(kGridMargin);
    grid.high = grid.low + cells;
    grid.size = grid.high + Vec3i::Constant(kGridMargin);
    // The box sits in the middle of its cells, so that a mirrored model gives the mirrored volume.
    const Vec3 shift =
        Vec3::Constant(kGridMargin) + (cells.cast<double>() - voxels).cwiseMax(0.0) / 2;
    grid.world_from_grid.voxel_size = voxel_size;
    grid.world_from_grid.rotation = options.rotation;
    grid.world_from_grid.origin = options.rotation * (min - voxel_size * shift);

    const auto snapped = [&](const Vec3& v) -> GridPoint {
        const Vec3 p = ((laid(v) - min) / voxel_size + shift) * kGridOne;
        return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
    };
    std::vector<std::uint32_t> point_of(mesh.vertices.size(), kNone);
    grid.points.reserve(mesh.vertices.size());
    if (connections.closed) {
        grid.closed = true;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            if (used[v] == 0) continue;
            point_of[v] = static_cast<std::uint32_t>(grid.points.size());
            grid.points.push_back(snapped(mesh.vertices[v]));
        }
        grid.triangles.reserve(mesh.triangles.size());
        for (const auto& [i, j, k] : mesh.triangles) {
            grid.triangles.push_back({point_of[i], point_of[j], point_of[k]});
        }
        return grid;
    }
    TripleTable table(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (used[v] == 0) continue;
        const GridPoint point = snapped(mesh.vertices[v]);
        point_of[v] = table.find_or_enter(point, grid.points);
        if (point_of[v] == kNone) {
            point_of[v] = static_cast<std::uint32_t>(grid.points.size());
            grid.points.push_back(point);
        }
    }
    take_triangles(mesh, point_of, grid);
    return grid;
}

}  // namespace ossuary::voxel
