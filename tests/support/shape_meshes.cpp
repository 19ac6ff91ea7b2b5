#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

/// Numbers the faces as a reader would that found one triangle a polygon.
mesh::TriangleMesh finished(mesh::TriangleMesh mesh) {
    mesh.face_of_triangle.resize(mesh.triangles.size());
    std::iota(mesh.face_of_triangle.begin(), mesh.face_of_triangle.end(), 0u);
    mesh.face_count = static_cast<std::uint32_t>(mesh.triangles.size());
    return mesh;
}

void add_quad(mesh::TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
              std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

}  // namespace

mesh::TriangleMesh open_box_mesh(const Vec3& low, const Vec3& high) {
    mesh::TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.vertices.emplace_back((corner & 1) ? high.x() : low.x(),
                                   (corner & 2) ? high.y() : low.y(),
                                   (corner & 4) ? high.z() : low.z());
    }
    add_quad(mesh, 0, 2, 3, 1);
    add_quad(mesh, 0, 1, 5, 4);
    add_quad(mesh, 1, 3, 7, 5);
    add_quad(mesh, 3, 2, 6, 7);
    add_quad(mesh, 2, 0, 4, 6);
    return finished(std::move(mesh));
}

mesh::TriangleMesh box_mesh(const Vec3& low, const Vec3& high) {
    mesh::TriangleMesh mesh = open_box_mesh(low, high);
    add_quad(mesh, 4, 5, 7, 6);
    return finished(std::move(mesh));
}

mesh::TriangleMesh icosphere_mesh(const Vec3& center, double radius, int subdivisions) {
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    mesh::TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int level = 0; level < subdivisions; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_of;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, added] = middle_of.try_emplace(
                std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
            if (added) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
            return place->second;
        };
        std::vector<mesh::TriangleMesh::Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Vec3& v : mesh.vertices) v = center + radius * v.normalized();
    return finished(std::move(mesh));
}

mesh::TriangleMesh torus_mesh(double major, double minor, int segments, int sides) {
    mesh::TriangleMesh mesh;
    for (int i = 0; i < segments; ++i) {
        const double u = 2 * std::numbers::pi * i / segments;
        for (int j = 0; j < sides; ++j) {
            const double v = 2 * std::numbers::pi * j / sides;
            const double r = major + minor * std::cos(v);
            mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
        }
    }
    const auto index = [=](int i, int j) {
        return static_cast<std::uint32_t>((i % segments) * sides + j % sides);
    };
    for (int i = 0; i < segments; ++i) {
        for (int j = 0; j < sides; ++j) {
            add_quad(mesh, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
        }
    }
    return finished(std::move(mesh));
}

mesh::TriangleMesh capsule_mesh(const Vec3& a, const Vec3& b, double radius, int sides) {
    const Vec3 axis = (b - a).normalized();
    const Vec3 side = axis.unitOrthogonal();
    const Vec3 other = axis.cross(side);
    const int half_rings = std::max(2, sides / 4);
    mesh::TriangleMesh mesh;
    mesh.vertices.push_back(a - radius * axis);
    for (int ring = 1; ring < 2 * half_rings + 1; ++ring) {
        const bool lower = ring <= half_rings;
        const double latitude =
            std::numbers::pi / 2 * ((lower ? ring : ring - 1) - half_rings) / half_rings;
        for (int j = 0; j < sides; ++j) {
            const double v = 2 * std::numbers::pi * j / sides;
            mesh.vertices.push_back(
                (lower ? a : b) +
                radius * (std::sin(latitude) * axis +
                          std::cos(latitude) * (std::cos(v) * side + std::sin(v) * other)));
        }
    }
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(b + radius * axis);
    const auto index = [=](int ring, int j) {
        return static_cast<std::uint32_t>(1 + ring * sides + j % sides);
    };
    const int last_ring = 2 * half_rings - 1;
    for (int j = 0; j < sides; ++j) {
        mesh.triangles.push_back({0, index(0, j + 1), index(0, j)});
        for (int ring = 0; ring < last_ring; ++ring) {
            add_quad(mesh, index(ring, j), index(ring, j + 1), index(ring + 1, j + 1),
                     index(ring + 1, j));
        }
        mesh.triangles.push_back({top, index(last_ring, j), index(last_ring, j + 1)});
    }
    return finished(std::move(mesh));
}

mesh::TriangleMesh capsule_tree_mesh(double scale) {
    mesh::TriangleMesh mesh;
    for (const Capsule& c : tree_capsules(scale)) {
        mesh = merged(mesh, capsule_mesh(c.a, c.b, c.radius));
    }
    return mesh;
}

mesh::TriangleMesh overlapping_spheres_mesh(double radius) {
    return merged(icosphere_mesh({0, 0, 0}, radius), icosphere_mesh({1.2 * radius, 0, 0}, radius));
}

mesh::TriangleMesh nested_spheres_mesh(double outer, double inner) {
    return merged(icosphere_mesh({0, 0, 0}, outer), icosphere_mesh({0, 0, 0}, inner));
}

std::vector<MeshShape> mesh_shapes() {
    return {{"box", box_mesh({0, 0, 0}, {3, 2, 1}), {1, 0, 0}},
            {"icosphere", icosphere_mesh({0, 0, 0}, 1), {1, 0, 0}},
            {"torus", torus_mesh(3, 1), {1, 1, 0}},
            {"capsule", capsule_mesh({0, 0, 0}, {5, 1, 2}, 1), {1, 0, 0}},
            {"capsule_tree", capsule_tree_mesh(), {1, 0, 0}},
            {"overlapping_spheres", overlapping_spheres_mesh(), {1, 0, 0}},
            {"nested_spheres", nested_spheres_mesh(), {1, 0, 0}}};
}

mesh::TriangleMesh merged(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    mesh::TriangleMesh result = a;
    const auto offset = static_cast<std::uint32_t>(a.vertices.size());
    result.vertices.insert(result.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles) {
        result.triangles.push_back({i + offset, j + offset, k + offset});
    }
    for (const std::uint32_t face : b.face_of_triangle) {
        result.face_of_triangle.push_back(a.face_count + face);
    }
    result.face_count = a.face_count + b.face_count;
    return result;
}

mesh::TriangleMesh transformed(const mesh::TriangleMesh& mesh, const Mat3& linear,
                               const Vec3& translation) {
    mesh::TriangleMesh result = mesh;
    for (Vec3& v : result.vertices) v = linear * v + translation;
    return result;
}

mesh::TriangleMesh flipped(const mesh::TriangleMesh& mesh) {
    mesh::TriangleMesh result = mesh;
    for (auto& t : result.triangles) std::swap(t[1], t[2]);
    return result;
}

mesh::TriangleMesh renumbered(const mesh::TriangleMesh& mesh, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<std::uint32_t> new_index(mesh.vertices.size());
    std::iota(new_index.begin(), new_index.end(), 0u);
    shuffle(new_index, random);
    mesh::TriangleMesh result = mesh;
    for (std::size_t i = 0; i < new_index.size(); ++i) {
        result.vertices[new_index[i]] = mesh.vertices[i];
    }
    std::vector<std::size_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, random);
    for (std::size_t i = 0; i < order.size(); ++i) {
        mesh::TriangleMesh::Triangle t = mesh.triangles[order[i]];
        std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(next_below(random, 3)),
                    t.end());
        result.triangles[i] = {new_index[t[0]], new_index[t[1]], new_index[t[2]]};
        result.face_of_triangle[i] = mesh.face_of_triangle[order[i]];
    }
    return result;
}

mesh::TriangleMesh without_some_triangles(const mesh::TriangleMesh& mesh, double share,
                                          std::uint64_t seed) {
    std::mt19937_64 random(seed);
    mesh::TriangleMesh result;
    result.vertices = mesh.vertices;
    for (const auto& t : mesh.triangles) {
        if (next_unit(random) >= share) result.triangles.push_back(t);
    }
    return finished(std::move(result));
}

Mat3 random_rotation(std::uint64_t seed) {
    // A uniformly distributed unit quaternion (Shoemake, "Uniform random rotations", 1992).
    std::mt19937_64 random(seed);
    const double u = next_unit(random);
    const double v = 2 * std::numbers::pi * next_unit(random);
    const double w = 2 * std::numbers::pi * next_unit(random);
    return Eigen::Quaterniond(std::sqrt(u) * std::cos(w), std::sqrt(1 - u) * std::sin(v),
                              std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w))
        .normalized()
        .toRotationMatrix();
}

}  // namespace ossuary::test
