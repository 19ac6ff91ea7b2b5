#pragma once

#include <cstdint>
#include <random>

#include "engine/mesh/triangle_mesh.h"

/// Small surfaces of known area, volume and topology, all oriented outwards.
namespace ossuary::test {

/// Sets `face_of_triangle` and `face_count` as for a file of triangles.
mesh::TriangleMesh with_faces(mesh::TriangleMesh mesh);

/// The cube [0, side]^3 from twelve triangles.
mesh::TriangleMesh cube_mesh(double side = 1.0);

/// A regular tetrahedron's connectivity on the origin and the three unit vectors.
mesh::TriangleMesh corner_tetrahedron();

/// A subdivided octahedron on the unit sphere: 8 * 4^levels triangles.
mesh::TriangleMesh sphere_mesh(int levels = 3);

mesh::TriangleMesh torus_mesh(int around = 32, int across = 16, double major = 2.0,
                              double minor = 0.75);

/// The unit square in z = 0 from cells^2 quads, each cut in two.
mesh::TriangleMesh square_mesh(int cells);

/// A band with half a twist.
mesh::TriangleMesh moebius_mesh(int segments = 24);

/// Both meshes in one.
mesh::TriangleMesh joined(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b);

/// Each triangle with three vertices of its own.
mesh::TriangleMesh as_soup(const mesh::TriangleMesh& mesh);

/// The mesh with vertices and triangles in another order and corners turned cyclically.
mesh::TriangleMesh renumbered(const mesh::TriangleMesh& mesh, std::uint64_t seed);

/// The mesh moved by a rotation, a scale and a shift.
mesh::TriangleMesh moved(const mesh::TriangleMesh& mesh, const Mat3& rotation, double scale,
                         const Vec3& shift);

/// A rotation that mixes all axes.
Mat3 some_rotation();

/// Reproducible on every platform, unlike the standard's distributions.
double uniform(std::mt19937_64& random, double low, double high);

}  // namespace ossuary::test
