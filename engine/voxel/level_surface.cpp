#include "engine/voxel/level_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace ossuary::voxel {
namespace {

constexpr int kCorners = 8;
constexpr int kEdges = 12;
constexpr std::uint32_t kNoCell = 0xFFFFFFFFu;

/// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2).
Vec3i corner_offset(int corner) { return {corner & 1, (corner >> 1) & 1, corner >> 2}; }

/// Edge 4 * axis + k runs along its axis from the k-th of the four corners that are 0 there.
constexpr std::array<std::array<int, 2>, kEdges> kCornersOfEdge = {{{0, 1},
                                                                    {2, 3},
                                                                    {4, 5},
                                                                    {6, 7},
                                                                    {0, 2},
                                                                    {1, 3},
                                                                    {4, 6},
                                                                    {5, 7},
                                                                    {0, 4},
                                                                    {1, 5},
                                                                    {2, 6},
                                                                    {3, 7}}};

/// The corners of each face of a cell, round about.
constexpr std::array<std::array<int, 4>, 6> kFaces = {
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

int edge_between(int a, int b) {
    if (a > b) std::swap(a, b);
    int edge = 0;
    while (kCornersOfEdge[static_cast<std::size_t>(edge)] != std::array<int, 2>{a, b}) ++edge;
    return edge;
}

/// Which edges of a cell one piece of the surface crosses: `piece[e]` is its number, or -1.
struct Pieces {
    std::array<std::int8_t, kEdges> piece{};
    int count = 0;
};

/// The pieces for corners of which those in `inside` are at the level or above. In each face with
/// crossings on all four edges the corners inside hold together.
Pieces find_pieces(unsigned inside) {
    const auto is_inside = [&](int corner) {
        return ((inside >> static_cast<unsigned>(corner)) & 1u) != 0;
    };
    std::array<int, kEdges> parent{};
    for (int e = 0; e < kEdges; ++e) parent[static_cast<std::size_t>(e)] = e;
    const auto root = [&](int e) {
        while (parent[static_cast<std::size_t>(e)] != e) e = parent[static_cast<std::size_t>(e)];
        return e;
    };
    for (const std::array<int, 4>& face : kFaces) {
        std::array<int, 4> crossed{};
        std::size_t crossings = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const int a = face[i], b = face[(i + 1) % 4];
            if (is_inside(a) != is_inside(b)) crossed[crossings++] = edge_between(a, b);
        }
        if (crossings == 2) parent[static_cast<std::size_t>(root(crossed[0]))] = root(crossed[1]);
        if (crossings != 4) continue;
        for (std::size_t i = 0; i < 4; ++i) {
            if (is_inside(face[i])) continue;
            const int before = edge_between(face[(i + 3) % 4], face[i]);
            const int after = edge_between(face[i], face[(i + 1) % 4]);
            parent[static_cast<std::size_t>(root(before))] = root(after);
        }
    }
    Pieces pieces;
    std::array<std::int8_t, kEdges> number{};
    number.fill(-1);
    for (std::size_t e = 0; e < kEdges; ++e) {
        const auto [a, b] = kCornersOfEdge[e];
        pieces.piece[e] = -1;
        if (is_inside(a) == is_inside(b)) continue;
        std::int8_t& of_root = number[static_cast<std::size_t>(root(static_cast<int>(e)))];
        if (of_root < 0) of_root = static_cast<std::int8_t>(pieces.count++);
        pieces.piece[e] = of_root;
    }
    return pieces;
}

std::vector<Pieces> all_pieces() {
    std::vector<Pieces> table;
    for (unsigned inside = 0; inside < 1u << kCorners; ++inside) {
        table.push_back(find_pieces(inside));
    }
    return table;
}

/// The cells of one layer that the surface passes through.
struct Layer {
    struct Cell {
        std::uint32_t first_vertex = 0;
        std::uint8_t inside = 0;
    };
    std::vector<std::uint32_t> cell_at;  ///< y * width + x
    std::vector<Cell> cells;
};

class SurfaceMaker {
public:
    SurfaceMaker(const ScalarGrid& grid, float level)
        : grid_(grid),
          level_(level),
          pieces_(all_pieces()),
          mirrored_(grid.axes.determinant() < 0) {}

    mesh::TriangleMesh make(const std::stop_token& stop);

private:
    [[nodiscard]] bool is_inside(int x, int y, int z) const { return grid_.at(x, y, z) >= level_; }
    void find_cells(int z, Layer& layer);
    void add_vertices(const Vec3i& cell, const Pieces& pieces);
    [[nodiscard]] Vec3 crossing(const Vec3i& cell, std::size_t edge) const;
    void add_faces(int z, const Layer& below, const Layer& above);
    void add_face(int axis, const Vec3i& start, const Layer& below, const Layer& above);
    [[nodiscard]] std::uint32_t vertex(const Layer& layer, const Vec3i& cell,
                                       std::size_t edge) const;

    const ScalarGrid& grid_;
    float level_;
    std::vector<Pieces> pieces_;
    bool mirrored_;
    mesh::TriangleMesh mesh_;
};

/// Where an edge of a cell crosses the level, in grid coordinates. Away from the edge's ends, so
/// that no two pieces meet there.
Vec3 SurfaceMaker::crossing(const Vec3i& cell, std::size_t edge) const {
    constexpr double kNearest = 0.02;
    const Vec3i a = cell + corner_offset(kCornersOfEdge[edge][0]);
    const Vec3i b = cell + corner_offset(kCornersOfEdge[edge][1]);
    const double at_a = double{grid_.at(a.x(), a.y(), a.z())};
    const double at_b = double{grid_.at(b.x(), b.y(), b.z())};
    const double share =
        std::clamp((double{level_} - at_a) / (at_b - at_a), kNearest, 1 - kNearest);
    return a.cast<double>() + share * (b - a).cast<double>();
}

void SurfaceMaker::add_vertices(const Vec3i& cell, const Pieces& pieces) {
    for (int piece = 0; piece < pieces.count; ++piece) {
        Vec3 sum = Vec3::Zero();
        int crossings = 0;
        for (std::size_t e = 0; e < kEdges; ++e) {
            if (pieces.piece[e] != piece) continue;
            sum += crossing(cell, e);
            ++crossings;
        }
        mesh_.vertices.push_back(grid_.world(sum / crossings));
    }
}

void SurfaceMaker::find_cells(int z, Layer& layer) {
    const int width = grid_.size.x() - 1, height = grid_.size.y() - 1;
    layer.cells.clear();
    layer.cell_at.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                         kNoCell);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            unsigned inside = 0;
            for (int corner = 0; corner < kCorners; ++corner) {
                const Vec3i at = Vec3i(x, y, z) + corner_offset(corner);
                if (is_inside(at.x(), at.y(), at.z()))
                    inside |= 1u << static_cast<unsigned>(corner);
            }
            if (inside == 0 || inside == 255) continue;
            layer.cell_at[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                          static_cast<std::size_t>(x)] =
                static_cast<std::uint32_t>(layer.cells.size());
            layer.cells.push_back({static_cast<std::uint32_t>(mesh_.vertices.size()),
                                   static_cast<std::uint8_t>(inside)});
            add_vertices({x, y, z}, pieces_[inside]);
        }
    }
}

std::uint32_t SurfaceMaker::vertex(const Layer& layer, const Vec3i& cell, std::size_t edge) const {
    const auto width = static_cast<std::size_t>(grid_.size.x() - 1);
    const std::uint32_t at = layer.cell_at[static_cast<std::size_t>(cell.y()) * width +
                                           static_cast<std::size_t>(cell.x())];
    const Layer::Cell& found = layer.cells[at];
    return found.first_vertex + static_cast<std::uint32_t>(pieces_[found.inside].piece[edge]);
}

/// The face that crosses the edge from `start` along `axis`: its corners lie in the four cells
/// around the edge, counter-clockwise as seen from the axis' far end.
void SurfaceMaker::add_face(int axis, const Vec3i& start, const Layer& below, const Layer& above) {
    constexpr std::array<std::array<int, 2>, 4> kRound = {{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
        Vec3i cell = start;
        cell[b] -= kRound[i][0];
        cell[c] -= kRound[i][1];
        // The edge as the cell numbers it, by the other two axes in the order x, y, z.
        const int first = std::min(b, c), second = std::max(b, c);
        const int k = (start[first] - cell[first]) + 2 * (start[second] - cell[second]);
        const Layer& layer = axis != 2 && cell.z() < start.z() ? below : above;
        corners[i] = vertex(layer, cell, static_cast<std::size_t>(4 * axis + k));
    }
    if (is_inside(start.x(), start.y(), start.z()) == mirrored_) std::swap(corners[1], corners[3]);
    const auto length = [&](std::size_t from, std::size_t to) {
        return (mesh_.vertices[corners[from]] - mesh_.vertices[corners[to]]).squaredNorm();
    };
    const std::size_t turn = length(0, 2) <= length(1, 3) ? 0 : 1;
    const auto corner = [&](std::size_t i) { return corners[(i + turn) % 4]; };
    mesh_.triangles.push_back({corner(0), corner(1), corner(2)});
    mesh_.triangles.push_back({corner(0), corner(2), corner(3)});
}

/// All faces across edges that lie in the plane of points z, or lead up from it.
void SurfaceMaker::add_faces(int z, const Layer& below, const Layer& above) {
    for (int y = 1; y + 1 < grid_.size.y(); ++y) {
        for (int x = 1; x + 1 < grid_.size.x(); ++x) {
            const bool here = is_inside(x, y, z);
            if (here != is_inside(x + 1, y, z)) add_face(0, {x, y, z}, below, above);
            if (here != is_inside(x, y + 1, z)) add_face(1, {x, y, z}, below, above);
            if (here != is_inside(x, y, z + 1)) add_face(2, {x, y, z}, below, above);
        }
    }
    // Edges from the border inwards; those along it cross nothing.
    for (int y = 1; y + 1 < grid_.size.y(); ++y) {
        if (is_inside(1, y, z)) add_face(0, {0, y, z}, below, above);
    }
    for (int x = 1; x + 1 < grid_.size.x(); ++x) {
        if (is_inside(x, 1, z)) add_face(1, {x, 0, z}, below, above);
    }
}

mesh::TriangleMesh SurfaceMaker::make(const std::stop_token& stop) {
    if (grid_.size.minCoeff() < 3) return {};
    Layer below, above;
    find_cells(0, above);
    // From the lowest layer of points only edges upwards may cross.
    for (int y = 1; y + 1 < grid_.size.y(); ++y) {
        for (int x = 1; x + 1 < grid_.size.x(); ++x) {
            if (is_inside(x, y, 1)) add_face(2, {x, y, 0}, below, above);
        }
    }
    for (int z = 1; z + 1 < grid_.size.z() && !stop.stop_requested(); ++z) {
        std::swap(below, above);
        find_cells(z, above);
        add_faces(z, below, above);
    }
    mesh_.face_count = static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.face_of_triangle.resize(mesh_.triangles.size());
    for (std::uint32_t t = 0; t < mesh_.face_count; ++t) mesh_.face_of_triangle[t] = t;
    return std::move(mesh_);
}

}  // namespace

mesh::TriangleMesh level_surface(const ScalarGrid& grid, float level, const std::stop_token& stop) {
    return SurfaceMaker(grid, level).make(stop);
}

}  // namespace ossuary::voxel
