#include "engine/mesh/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/mesh/measures.h"
#include "engine/mesh/vertex_table.h"

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kNone = WeldResult::kUnused;

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
}

/// The smallest vertex index at each position.
std::vector<std::uint32_t> merge_equal(const std::vector<Vec3>& vertices) {
    VertexTable table(vertices.size());
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> target(vertices.size());
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        const std::uint32_t number = table.number_of(vertices[v]);
        if (number == first.size()) first.push_back(v);
        target[v] = first[number];
    }
    return target;
}

/// How far from it each vertex is merged with others; negative for unused ones, which may lie
/// anywhere, also where cell numbers overflow.
std::vector<double> reaches(const TriangleMesh& mesh, const std::vector<std::uint32_t>& target,
                            const WeldOptions& options, double diagonal) {
    constexpr double kUnseen = -1.0;
    std::vector<double> shortest(mesh.vertices.size(), kUnseen);
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = target[triangle[i]], b = target[triangle[(i + 1) % 3]];
            double length = (mesh.vertices[a] - mesh.vertices[b]).norm();
            if (a == b) length = std::numeric_limits<double>::infinity();
            for (const std::uint32_t end : {a, b}) {
                if (shortest[end] == kUnseen || length < shortest[end]) shortest[end] = length;
            }
        }
    }
    for (double& reach : shortest) {
        if (reach == kUnseen) continue;
        reach = std::clamp(options.edge_share * reach, options.sure_tolerance * diagonal,
                           options.tolerance * diagonal);
    }
    return shortest;
}

/// Vertices in cells of a grid, by open addressing; those of one cell are chained.
class CellGrid {
public:
    using Cell = std::array<std::int64_t, 3>;
    explicit CellGrid(std::size_t vertices)
        : slots_(std::bit_ceil(2 * vertices + 1)), next_(vertices, kNone) {}

    void add(const Cell& cell, std::uint32_t vertex) {
        Slot& slot = slots_[slot_of(cell)];
        next_[vertex] = slot.last;
        slot = {cell, vertex};
    }
    /// The vertex that was added last, or kNone; before it came next_in_cell.
    [[nodiscard]] std::uint32_t last_in(const Cell& cell) const {
        return slots_[slot_of(cell)].last;
    }
    [[nodiscard]] std::uint32_t before(std::uint32_t vertex) const { return next_[vertex]; }

private:
    struct Slot {
        Cell cell{};
        std::uint32_t last = kNone;
    };
    [[nodiscard]] std::size_t slot_of(const Cell& cell) const {
        std::uint64_t hash = 0;
        for (const std::int64_t i : cell) hash = mix(hash, static_cast<std::uint64_t>(i));
        std::size_t slot = (hash >> 7) & (slots_.size() - 1);
        while (slots_[slot].last != kNone && slots_[slot].cell != cell) {
            slot = (slot + 1) & (slots_.size() - 1);
        }
        return slot;
    }
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> next_;
};

/// Each vertex goes to the first kept one within both reaches, else it is kept itself. Cells are so
/// much larger than the reach that most vertices look into one only.
void merge_near(const std::vector<Vec3>& vertices, const Vec3& origin,
                const std::vector<double>& reach, double cell_size,
                std::vector<std::uint32_t>& target) {
    CellGrid grid(vertices.size());
    const auto cell_of = [&](const Vec3& point) {
        CellGrid::Cell cell{};
        for (int axis = 0; axis < 3; ++axis) {
            const double scaled = (point[axis] - origin[axis]) / cell_size;
            cell[static_cast<std::size_t>(axis)] = std::llround(std::floor(scaled));
        }
        return cell;
    };
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        if (target[v] != v) {
            target[v] = target[target[v]];
            continue;
        }
        if (reach[v] < 0.0) continue;
        const auto low = cell_of(vertices[v] - Vec3::Constant(reach[v]));
        const auto high = cell_of(vertices[v] + Vec3::Constant(reach[v]));
        std::uint32_t best = v;
        CellGrid::Cell cell{};
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) {
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
                    for (std::uint32_t kept = grid.last_in(cell); kept != kNone;
                         kept = grid.before(kept)) {
                        if (kept >= best) continue;
                        const double distance = (vertices[kept] - vertices[v]).norm();
                        if (distance <= std::min(reach[v], reach[kept])) best = kept;
                    }
                }
            }
        }
        target[v] = best;
        if (best == v) grid.add(cell_of(vertices[v]), v);
    }
}

/// For each vertex the one that it is merged into.
std::vector<std::uint32_t> merge_vertices(const TriangleMesh& mesh, const WeldOptions& options) {
    std::vector<std::uint32_t> target = merge_equal(mesh.vertices);
    // Below a part in 10^12 the cells would outgrow their integers; coordinates are no finer.
    if (options.tolerance < 1e-12) return target;
    const MeshMeasures measures = measure(mesh);
    const double distance = options.tolerance * measures.diagonal;
    if (!(distance > 0.0)) return target;
    const std::vector<double> reach = reaches(mesh, target, options, measures.diagonal);
    constexpr double kCellSize = 8.0;  // in distances
    merge_near(mesh.vertices, measures.bounds.min(), reach, kCellSize * distance, target);
    return target;
}

}  // namespace

WeldResult weld(const TriangleMesh& mesh, const WeldOptions& options) {
    const std::vector<std::uint32_t> target = merge_vertices(mesh, options);
    WeldResult result;
    for (std::uint32_t v = 0; v < target.size(); ++v) {
        result.merged_vertices += target[v] != v ? 1 : 0;
    }
    result.mesh.face_count = mesh.face_count;
    result.mesh.triangles.reserve(mesh.triangles.size());
    const bool mapped = mesh.face_of_triangle.size() == mesh.triangles.size();
    const bool coloured = !mesh.corner_colours.empty();
    result.vertex_of.assign(mesh.vertices.size(), kNone);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        TriangleMesh::Triangle triangle = mesh.triangles[t];
        for (std::uint32_t& vertex : triangle) vertex = target[vertex];
        if (options.drop_collapsed && (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                                       triangle[2] == triangle[0])) {
            ++result.dropped_triangles;
            continue;
        }
        for (std::uint32_t& vertex : triangle) {
            std::uint32_t& renumbered = result.vertex_of[vertex];
            if (renumbered == kNone) {
                renumbered = static_cast<std::uint32_t>(result.mesh.vertices.size());
                result.mesh.vertices.push_back(mesh.vertices[vertex]);
            }
            vertex = renumbered;
        }
        result.mesh.triangles.push_back(triangle);
        result.source_triangle.push_back(t);
        if (mapped) result.mesh.face_of_triangle.push_back(mesh.face_of_triangle[t]);
        if (coloured) result.mesh.corner_colours.push_back(mesh.corner_colours[t]);
    }
    for (std::uint32_t v = 0; v < target.size(); ++v) {
        if (target[v] != v) result.vertex_of[v] = result.vertex_of[target[v]];
    }
    return result;
}

}  // namespace ossuary::mesh
