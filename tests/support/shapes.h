#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "engine/mesh/triangle_mesh.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary {

/// How GoogleTest writes Betti numbers in its messages.
inline void PrintTo(const voxel::BettiNumbers& betti, std::ostream* out) {
    *out << "(" << betti.components << " components, " << betti.tunnels << " tunnels, "
         << betti.cavities << " cavities)";
}

}  // namespace ossuary

/// Built shapes with a known topology: volumes for the stages after voxelization, meshes for those
/// before it.
namespace ossuary::test {

// ---- volumes: every one has at least two empty layers on each side ----

struct VolumeShape {
    std::string name;
    voxel::BitVolume volume;
    voxel::BettiNumbers betti;  ///< known from how the shape was built
};

VolumeShape ball(double radius = 20.0);
VolumeShape bar(const Vec3i& size = {4, 4, 100});
VolumeShape cube(int side = 128);
VolumeShape plate(const Vec3i& size = {60, 60, 1});
VolumeShape torus(double major = 24.0, double minor = 7.0);
VolumeShape double_torus(double major = 20.0, double minor = 6.0);
VolumeShape hollow_ball(double outer = 20.0, double inner = 10.0);
struct Capsule {
    Vec3 a;
    Vec3 b;
    double radius;
};
voxel::BitVolume capsule_volume(const std::vector<Capsule>& capsules);
/// The parts of `capsule_tree` and `capsule_tree_mesh`.
std::vector<Capsule> tree_capsules(double scale = 1.0);

/// A trunk, four limbs of different length and thickness and two twigs: six tips.
VolumeShape capsule_tree(double scale = 1.0);
/// A trefoil knot: one tunnel, whatever its winding.
VolumeShape trefoil_knot(double scale = 12.0, double tube = 4.0);
/// Two rings through each other that do not touch.
VolumeShape linked_tori(double major = 20.0, double minor = 4.0);

/// One of each of the above in its default size.
std::vector<VolumeShape> volume_shapes();

/// Each voxel set with probability `density`, independently; the same for the same seed. Voxels of
/// the outermost layer are set like all others.
voxel::BitVolume random_volume(const Vec3i& size, double density, std::uint64_t seed);

/// Sets the voxels of `bounds` (in voxels from the origin; moved into the volume with a margin of
/// two) whose centre satisfies `inside`.
voxel::BitVolume sample_volume(const Box3& bounds, const std::function<bool(const Vec3&)>& inside);

/// The volume with its axes permuted: axis i of the result is axis order[i] of the input.
voxel::BitVolume permuted(const voxel::BitVolume& volume, const Vec3i& order);
/// The volume reversed along one axis.
voxel::BitVolume mirrored(const voxel::BitVolume& volume, int axis);

// ---- meshes: outward orientation, counter-clockwise seen from outside ----

struct MeshShape {
    std::string name;
    mesh::TriangleMesh mesh;
    voxel::BettiNumbers betti;  ///< of the solid that it bounds, cavities filled
};

mesh::TriangleMesh box_mesh(const Vec3& low, const Vec3& high);
/// A box without the face at high z.
mesh::TriangleMesh open_box_mesh(const Vec3& low, const Vec3& high);
mesh::TriangleMesh icosphere_mesh(const Vec3& center, double radius, int subdivisions = 3);
mesh::TriangleMesh torus_mesh(double major, double minor, int segments = 64, int sides = 32);
mesh::TriangleMesh capsule_mesh(const Vec3& a, const Vec3& b, double radius, int sides = 24);
/// Overlapping closed capsules, the mesh of `capsule_tree`.
mesh::TriangleMesh capsule_tree_mesh(double scale = 1.0);
/// Two spheres of one size whose centres are 1.2 radii apart: self-intersecting, one solid.
mesh::TriangleMesh overlapping_spheres_mesh(double radius = 1.0);
/// A sphere in a sphere, both oriented outwards.
mesh::TriangleMesh nested_spheres_mesh(double outer = 1.0, double inner = 0.5);

/// Closed meshes of one solid each.
std::vector<MeshShape> mesh_shapes();

/// Both meshes in one, nothing welded.
mesh::TriangleMesh merged(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b);
/// Every vertex v becomes linear * v + translation.
mesh::TriangleMesh transformed(const mesh::TriangleMesh& mesh, const Mat3& linear,
                               const Vec3& translation = Vec3::Zero());
/// Every triangle turned over.
mesh::TriangleMesh flipped(const mesh::TriangleMesh& mesh);
/// The same surface with vertices renumbered, triangles reordered and corners rotated.
mesh::TriangleMesh renumbered(const mesh::TriangleMesh& mesh, std::uint64_t seed);
/// Without a random share of its triangles.
mesh::TriangleMesh without_some_triangles(const mesh::TriangleMesh& mesh, double share,
                                          std::uint64_t seed);
/// Uniformly distributed over the rotations; the same for the same seed.
Mat3 random_rotation(std::uint64_t seed);

}  // namespace ossuary::test
