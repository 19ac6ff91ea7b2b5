#include "tests/engine/mesh/built_meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace ossuary::test {
namespace {

using Index = std::uint32_t;

void shuffle(std::vector<Index>& order, std::mt19937_64& random) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
}

}  // namespace

mesh::TriangleMesh with_faces(mesh::TriangleMesh mesh) {
    mesh.face_count = static_cast<Index>(mesh.triangles.size());
    mesh.face_of_triangle.resize(mesh.triangles.size());
    std::iota(mesh.face_of_triangle.begin(), mesh.face_of_triangle.end(), 0u);
    return mesh;
}

mesh::TriangleMesh cube_mesh(double side) {
    mesh::TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.push_back(side * Vec3(i & 1, i >> 1 & 1, i >> 2));
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return with_faces(mesh);
}

mesh::TriangleMesh corner_tetrahedron() {
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return with_faces(mesh);
}

mesh::TriangleMesh sphere_mesh(int levels) {
    mesh::TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        mesh.vertices.push_back(Vec3::Unit(axis));
        mesh.vertices.push_back(-Vec3::Unit(axis));
    }
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<Index, Index>, Index> middles;
        const auto middle = [&](Index a, Index b) {
            const auto [at, fresh] =
                middles.try_emplace(std::minmax(a, b), Index(mesh.vertices.size()));
            if (fresh) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            return at->second;
        };
        std::vector<mesh::TriangleMesh::Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    return with_faces(mesh);
}

mesh::TriangleMesh torus_mesh(int around, int across, double major, double minor) {
    mesh::TriangleMesh mesh;
    for (int i = 0; i < around; ++i) {
        const double u = 2 * std::numbers::pi * i / around;
        for (int j = 0; j < across; ++j) {
            const double v = 2 * std::numbers::pi * j / across;
            const double r = major + minor * std::cos(v);
            mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
        }
    }
    const auto at = [&](int i, int j) { return Index((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return with_faces(mesh);
}

mesh::TriangleMesh square_mesh(int cells) {
    mesh::TriangleMesh mesh;
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            mesh.vertices.emplace_back(double(x) / cells, double(y) / cells, 0);
        }
    }
    const auto at = [&](int x, int y) { return Index(y * (cells + 1) + x); };
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            mesh.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    }
    return with_faces(mesh);
}

mesh::TriangleMesh moebius_mesh(int segments) {
    mesh::TriangleMesh mesh;
    for (int i = 0; i < segments; ++i) {
        const double u = 2 * std::numbers::pi * i / segments;
        for (const double w : {-0.3, 0.3}) {
            const double r = 1 + w * std::cos(u / 2);
            mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
        }
    }
    for (int i = 0; i < segments; ++i) {
        const bool last = i + 1 == segments;
        const auto a = Index(2 * i), b = Index(2 * i + 1);
        const Index c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        mesh.triangles.push_back({a, c, d});
        mesh.triangles.push_back({a, d, b});
    }
    return with_faces(mesh);
}

mesh::TriangleMesh joined(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    mesh::TriangleMesh mesh = a;
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (mesh::TriangleMesh::Triangle triangle : b.triangles) {
        for (Index& vertex : triangle) vertex += Index(a.vertices.size());
        mesh.triangles.push_back(triangle);
    }
    return with_faces(mesh);
}

mesh::TriangleMesh as_soup(const mesh::TriangleMesh& mesh) {
    mesh::TriangleMesh soup;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const Vec3& corner : mesh.corners(t)) soup.vertices.push_back(corner);
        const auto first = Index(3 * t);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return with_faces(soup);
}

mesh::TriangleMesh renumbered(const mesh::TriangleMesh& mesh, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<Index> place(mesh.vertices.size());
    std::iota(place.begin(), place.end(), 0u);
    shuffle(place, random);
    std::vector<Index> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    shuffle(order, random);
    mesh::TriangleMesh result;
    result.vertices.resize(mesh.vertices.size());
    for (std::size_t v = 0; v < place.size(); ++v) result.vertices[place[v]] = mesh.vertices[v];
    for (const Index t : order) {
        const std::size_t turn = random() % 3;
        mesh::TriangleMesh::Triangle triangle{};
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = place[mesh.triangles[t][(i + turn) % 3]];
        result.triangles.push_back(triangle);
    }
    return with_faces(result);
}

mesh::TriangleMesh moved(const mesh::TriangleMesh& mesh, const Mat3& rotation, double scale,
                         const Vec3& shift) {
    mesh::TriangleMesh result = mesh;
    for (Vec3& vertex : result.vertices) vertex = scale * (rotation * vertex) + shift;
    return result;
}

Mat3 some_rotation() {
    return Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

}  // namespace ossuary::test
