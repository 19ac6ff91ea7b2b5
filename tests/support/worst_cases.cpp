#include "tests/support/worst_cases.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "engine/core/geometry.h"
#include "tests/support/random.h"

namespace ossuary::test {
namespace {

using mesh::TriangleMesh;

constexpr double kHalfTurn = std::numbers::pi;
constexpr std::uint64_t kSeed = 1;

/// Numbers the faces, and leaves coordinates seven decimals, so that files stay short.
TriangleMesh numbered(TriangleMesh mesh) {
    for (Vec3& vertex : mesh.vertices) vertex = (vertex * 1e7).array().round() / 1e7;
    mesh.face_of_triangle.resize(mesh.triangles.size());
    std::iota(mesh.face_of_triangle.begin(), mesh.face_of_triangle.end(), 0u);
    mesh.face_count = static_cast<std::uint32_t>(mesh.triangles.size());
    return mesh;
}

std::uint32_t add_vertex(TriangleMesh& mesh, const Vec3& position) {
    mesh.vertices.push_back(position);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_corners(TriangleMesh& mesh, const std::array<std::uint32_t, 4>& corners) {
    const auto& [a, b, c, d] = corners;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// The quads of a tube whose rings of `sides` vertices lie one after the other, and a fan at each
/// end.
void add_tube(TriangleMesh& mesh, std::size_t rings, std::size_t sides, const Vec3& begin,
              const Vec3& end) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size() - rings * sides);
    const auto at = [=](std::size_t ring, std::size_t side) {
        return first + static_cast<std::uint32_t>(ring * sides + side % sides);
    };
    for (std::size_t r = 0; r + 1 < rings; ++r) {
        for (std::size_t s = 0; s < sides; ++s) {
            add_corners(mesh, {at(r, s), at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
        }
    }
    const std::uint32_t bottom = add_vertex(mesh, begin);
    const std::uint32_t top = add_vertex(mesh, end);
    for (std::size_t s = 0; s < sides; ++s) {
        mesh.triangles.push_back({bottom, at(0, s + 1), at(0, s)});
        mesh.triangles.push_back({top, at(rings - 1, s), at(rings - 1, s + 1)});
    }
}

using InCell = std::function<bool(int, int, int)>;

/// The faces between cells that are inside and cells that are not, of a cube of cells; corners are
/// shared.
TriangleMesh cell_surface(int cells, const InCell& inside) {
    TriangleMesh mesh;
    const int corners = cells + 1;
    std::vector<std::uint32_t> vertex_at(static_cast<std::size_t>(corners) *
                                             static_cast<std::size_t>(corners) *
                                             static_cast<std::size_t>(corners),
                                         std::numeric_limits<std::uint32_t>::max());
    const auto vertex = [&](const Vec3i& c) {
        std::uint32_t& index =
            vertex_at[static_cast<std::size_t>((c.z() * corners + c.y()) * corners + c.x())];
        if (index == std::numeric_limits<std::uint32_t>::max()) {
            index = add_vertex(mesh, c.cast<double>());
        }
        return index;
    };
    const auto filled = [&](const Vec3i& c) {
        const bool in_cube = c.minCoeff() >= 0 && c.maxCoeff() < cells;
        return in_cube && inside(c.x(), c.y(), c.z());
    };
    for (int i = 0; i < cells * cells * cells; ++i) {
        const Vec3i cell(i % cells, i / cells % cells, i / cells / cells);
        if (!filled(cell)) continue;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3i along = Vec3i::Unit(axis);
            const Vec3i u = Vec3i::Unit((axis + 1) % 3);
            const Vec3i v = Vec3i::Unit((axis + 2) % 3);
            if (!filled(cell - along)) {
                add_corners(
                    mesh, {vertex(cell), vertex(cell + v), vertex(cell + u + v), vertex(cell + u)});
            }
            if (!filled(cell + along)) {
                const Vec3i far = cell + along;
                add_corners(mesh,
                            {vertex(far), vertex(far + u), vertex(far + u + v), vertex(far + v)});
            }
        }
    }
    return mesh;
}

TriangleMesh sphere_mesh(std::size_t triangles) {
    const double wanted = static_cast<double>(triangles) / 2;
    const auto sides = static_cast<std::size_t>(std::lround(std::sqrt(wanted)));
    const std::size_t rings = std::max<std::size_t>(sides - 1, 2);
    TriangleMesh mesh;
    for (std::size_t r = 0; r < rings; ++r) {
        const double latitude =
            kHalfTurn * (static_cast<double>(r + 1) / static_cast<double>(rings + 1));
        for (std::size_t s = 0; s < sides; ++s) {
            const double angle =
                2 * kHalfTurn * static_cast<double>(s) / static_cast<double>(sides);
            mesh.vertices.emplace_back(std::sin(latitude) * std::cos(angle),
                                       std::sin(latitude) * std::sin(angle), -std::cos(latitude));
        }
    }
    add_tube(mesh, rings, sides, {0, 0, -1}, {0, 0, 1});
    return numbered(std::move(mesh));
}

TriangleMesh giant_triangle_mesh(std::size_t triangles) {
    TriangleMesh mesh = sphere_mesh(triangles);
    const std::uint32_t a = add_vertex(mesh, {-1000, -1000, 0.1});
    const std::uint32_t b = add_vertex(mesh, {1000, -900, 0.2});
    const std::uint32_t c = add_vertex(mesh, {0, 1000, -0.3});
    mesh.triangles.push_back({a, b, c});
    return numbered(std::move(mesh));
}

TriangleMesh plate_mesh(std::size_t quads_along) {
    TriangleMesh mesh;
    const auto n = static_cast<std::uint32_t>(quads_along);
    const auto at = [n](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return (z * (n + 1) + y) * (n + 1) + x;
    };
    for (int z = 0; z < 2; ++z) {
        for (std::uint32_t y = 0; y <= n; ++y) {
            for (std::uint32_t x = 0; x <= n; ++x) {
                mesh.vertices.emplace_back(1000.0 * x / n, 1000.0 * y / n, z);
            }
        }
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            add_corners(mesh, {at(x, y, 0), at(x, y + 1, 0), at(x + 1, y + 1, 0), at(x + 1, y, 0)});
            add_corners(mesh, {at(x, y, 1), at(x + 1, y, 1), at(x + 1, y + 1, 1), at(x, y + 1, 1)});
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        add_corners(mesh, {at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1)});
        add_corners(mesh, {at(i + 1, n, 0), at(i, n, 0), at(i, n, 1), at(i + 1, n, 1)});
        add_corners(mesh, {at(0, i + 1, 0), at(0, i, 0), at(0, i, 1), at(0, i + 1, 1)});
        add_corners(mesh, {at(n, i, 0), at(n, i + 1, 0), at(n, i + 1, 1), at(n, i, 1)});
    }
    return numbered(std::move(mesh));
}

TriangleMesh helix_mesh(std::size_t triangles) {
    constexpr std::size_t kSides = 12;
    constexpr double kTurns = 30.0, kPitch = 0.06, kTube = 0.015;
    const std::size_t rings = triangles / (2 * kSides) + 2;
    const auto middle = [&](double t) {
        const double angle = 2 * kHalfTurn * kTurns * t;
        return Vec3(std::cos(angle), std::sin(angle), kPitch * kTurns * t);
    };
    TriangleMesh mesh;
    for (std::size_t r = 0; r < rings; ++r) {
        const double t = static_cast<double>(r) / static_cast<double>(rings - 1);
        const double turn = 2 * kHalfTurn * kTurns * t;
        const Vec3 outwards(std::cos(turn), std::sin(turn), 0);
        for (std::size_t s = 0; s < kSides; ++s) {
            const double angle = 2 * kHalfTurn * static_cast<double>(s) / kSides;
            mesh.vertices.push_back(
                middle(t) + kTube * (std::cos(angle) * outwards + std::sin(angle) * Vec3::UnitZ()));
        }
    }
    add_tube(mesh, rings, kSides, middle(0), middle(1));
    return numbered(std::move(mesh));
}

TriangleMesh cylinder_of_slivers_mesh(std::size_t triangles) {
    const std::size_t sides = triangles / 4;
    TriangleMesh mesh;
    for (const double z : {0.0, 2.0}) {
        for (std::size_t s = 0; s < sides; ++s) {
            const double angle =
                2 * kHalfTurn * static_cast<double>(s) / static_cast<double>(sides);
            mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), z);
        }
    }
    add_tube(mesh, 2, sides, {0, 0, 0}, {0, 0, 2});
    return numbered(std::move(mesh));
}

Vec3 random_point(std::mt19937_64& random) {
    const double x = next_unit(random), y = next_unit(random), z = next_unit(random);
    return {x, y, z};
}

TriangleMesh random_triangles(std::size_t triangles) {
    std::mt19937_64 random(kSeed);
    TriangleMesh mesh;
    for (std::size_t t = 0; t < triangles; ++t) {
        const std::uint32_t a = add_vertex(mesh, random_point(random));
        const std::uint32_t b = add_vertex(mesh, random_point(random));
        mesh.triangles.push_back({a, b, add_vertex(mesh, random_point(random))});
    }
    return numbered(std::move(mesh));
}

TriangleMesh random_slivers(std::size_t triangles) {
    std::mt19937_64 random(kSeed);
    TriangleMesh mesh;
    for (std::size_t t = 0; t < triangles; ++t) {
        const std::uint32_t a = add_vertex(mesh, random_point(random));
        const Vec3 beside = mesh.vertices[a] + 1e-4 * random_point(random);
        const std::uint32_t b = add_vertex(mesh, random_point(random));
        mesh.triangles.push_back({a, b, add_vertex(mesh, beside)});
    }
    return numbered(std::move(mesh));
}

TriangleMesh random_boxes(std::size_t boxes) {
    std::mt19937_64 random(kSeed);
    TriangleMesh mesh;
    for (std::size_t i = 0; i < boxes; ++i) {
        const Vec3 low = random_point(random);
        const Vec3 size = 0.005 * (Vec3::Ones() + random_point(random));
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 0; corner < 8; ++corner) {
            add_vertex(mesh,
                       low + size.cwiseProduct(Vec3(corner & 1, corner >> 1 & 1, corner >> 2)));
        }
        for (const auto& [a, b, c, d] : {std::array{0u, 2u, 3u, 1u},
                                         {4u, 5u, 7u, 6u},
                                         {0u, 1u, 5u, 4u},
                                         {1u, 3u, 7u, 5u},
                                         {3u, 2u, 6u, 7u},
                                         {2u, 0u, 4u, 6u}}) {
            add_corners(mesh, {first + a, first + b, first + c, first + d});
        }
    }
    return numbered(std::move(mesh));
}

TriangleMesh gyroid_mesh(std::size_t cells) {
    const double step = 8 * kHalfTurn / static_cast<double>(cells);  // four periods
    const auto value = [](const Vec3& p) {
        return std::sin(p.x()) * std::cos(p.y()) + std::sin(p.y()) * std::cos(p.z()) +
               std::sin(p.z()) * std::cos(p.x());
    };
    const auto at = [&](int x, int y, int z) {
        return value(step * (Vec3(x, y, z) + Vec3::Constant(0.5)));
    };
    TriangleMesh mesh =
        cell_surface(static_cast<int>(cells), [&](int x, int y, int z) { return at(x, y, z) > 0; });
    // Off the cells' corners onto the surface, but for what lies on the cube's faces.
    for (Vec3& vertex : mesh.vertices) {
        if (vertex.minCoeff() == 0 || vertex.maxCoeff() == static_cast<double>(cells)) continue;
        const Vec3 p = step * vertex;
        const Vec3 gradient(std::cos(p.x()) * std::cos(p.y()) - std::sin(p.z()) * std::sin(p.x()),
                            std::cos(p.y()) * std::cos(p.z()) - std::sin(p.x()) * std::sin(p.y()),
                            std::cos(p.z()) * std::cos(p.x()) - std::sin(p.y()) * std::sin(p.z()));
        const double squared = std::max(gradient.squaredNorm(), 0.1);
        vertex -= (value(p) / squared * gradient / step).cwiseMax(-0.5).cwiseMin(0.5);
    }
    return numbered(std::move(mesh));
}

/// Bars along the edges of cubes, three cells to a cube.
TriangleMesh lattice_mesh(std::size_t cubes) {
    return numbered(cell_surface(static_cast<int>(3 * cubes + 1), [](int x, int y, int z) {
        return (x % 3 == 0) + (y % 3 == 0) + (z % 3 == 0) >= 2;
    }));
}

TriangleMesh checkerboard_mesh(std::size_t cells) {
    return numbered(cell_surface(static_cast<int>(cells),
                                 [](int x, int y, int z) { return (x + y + z) % 2 == 0; }));
}

TriangleMesh menger_sponge_mesh(std::size_t level) {
    int cells = 1;
    for (std::size_t i = 0; i < level; ++i) cells *= 3;
    return numbered(cell_surface(cells, [cells](int x, int y, int z) {
        for (int size = cells; size > 1; size /= 3, x /= 3, y /= 3, z /= 3) {
            if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
        }
        return true;
    }));
}

TriangleMesh voxel_noise_mesh(std::size_t cells) {
    std::mt19937_64 random(kSeed);
    std::vector<bool> filled(cells * cells * cells);
    for (auto&& cell : filled) cell = next_unit(random) < 0.5;
    return numbered(cell_surface(static_cast<int>(cells), [&](int x, int y, int z) {
        return filled[(static_cast<std::size_t>(z) * cells + static_cast<std::size_t>(y)) * cells +
                      static_cast<std::size_t>(x)];
    }));
}

constexpr std::array kCases = {
    WorstCase{"giant_triangle", "a sphere of so many triangles and one 1,000 times its size",
              100'000, 2'000, giant_triangle_mesh},
    WorstCase{"plate", "a plate of 1000:1000:1, so many squares along a side", 500, 20, plate_mesh},
    WorstCase{"helix", "a wire of 30 turns, so many triangles", 500'000, 20'000, helix_mesh},
    WorstCase{"boxes", "so many small boxes anywhere in a cube", 100'000, 2'000, random_boxes},
    WorstCase{"gyroid", "the solid on one side of a gyroid, so many cells along a side", 208, 40,
              gyroid_mesh},
    WorstCase{"lattice", "bars along the edges of so many cubes along a side", 24, 5, lattice_mesh},
    WorstCase{"checkerboard", "every second cell, so many along a side", 64, 12, checkerboard_mesh},
    WorstCase{"menger_sponge", "of this level", 4, 2, menger_sponge_mesh},
    WorstCase{"voxel_noise", "each cell with a chance of 1/2, so many along a side", 64, 16,
              voxel_noise_mesh},
    WorstCase{"sphere_1m", "a sphere of so many triangles", 1'000'000, 20'000, sphere_mesh},
    WorstCase{"sphere_10m", "a sphere of so many triangles", 9'900'000, 40'000, sphere_mesh},
    WorstCase{"cylinder_of_slivers", "a cylinder of so many triangles as long as it", 2'000'000,
              20'000, cylinder_of_slivers_mesh},
    WorstCase{"slivers_500k", "so many triangles without width across a cube", 500'000, 3'000,
              random_slivers},
    WorstCase{"triangles_500k", "so many triangles of three random points in a cube", 500'000,
              2'000, random_triangles},
    WorstCase{"triangles_1m", "so many triangles of three random points in a cube", 1'000'000,
              4'000, random_triangles},
};

}  // namespace

std::span<const WorstCase> worst_cases() { return kCases; }

const WorstCase& worst_case(std::string_view name) {
    const auto found = std::find_if(kCases.begin(), kCases.end(),
                                    [name](const WorstCase& c) { return c.name == name; });
    assert(found != kCases.end());
    return *found;
}

}  // namespace ossuary::test
