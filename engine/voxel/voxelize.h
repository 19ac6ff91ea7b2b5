#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/body.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/voxel/bit_volume.h"

namespace ossuary::voxel {

struct VoxelizeOptions {
    /// Voxels along the longest side of the bounding box of what counts, in [8, 1024].
    int resolution = 96;
    /// The grid's axes as columns, in model coordinates, orthonormal: voxelizes the model as seen
    /// in this pose, which is a mirrored one where the determinant is -1. The bounding box is that
    /// of the pose.
    Mat3 rotation = Mat3::Identity();
    /// Keep parts thinner than a voxel as sheets and lines of one voxel; else the solid is what
    /// sampling at voxel centres gives.
    bool keep_thin_parts = true;
    bool fill_cavities = true;  ///< set what cannot be reached from outside through faces
    /// Close tunnels that are at most about two voxels wide, unless the model is one closed surface
    /// of at least as many handles: what voxelization makes of parts that nearly touch.
    bool close_small_tunnels = true;
    /// Join components that are at most this many empty voxels apart by a line of voxels; 0 to 4.
    int bridge_gap = 2;
    /// Components that could not be joined and whose longest side is below this share of the
    /// largest component's are dropped; 0 keeps all.
    /// Such pieces of the mesh that lie apart do not set the grid's scale either (mesh/body.h).
    double min_component_extent = 0.1;
    /// Lay the grid over all of the mesh; for those that have left out what does not count.
    bool whole_mesh = false;

    /// Gaps are closed, the narrowest first (close_gaps.h), until the solid has at most so many
    /// components, tunnels and cavities: no skeleton of more is worth looking at, and none that
    /// could be compared. 0 leaves it as it is.
    std::size_t max_intricacy = kMaxIntricacy;

    static constexpr std::size_t kMaxIntricacy = 400;
};

/// A model as a solid.
struct VoxelSolid {
    BitVolume volume;  ///< two empty layers on every side
    WorldFromGrid world_from_grid;
    /// Codes: open_surface, repeated_triangles, dense_surface (inside and outside cannot be
    /// told apart: everything that the surface passes through counts as solid), thin_parts (voxels
    /// that keep parts thinner than a voxel), closed_gaps (too intricate: gaps up to this many
    /// voxels wide were closed), filled_cavities, closed_tunnels, bridged_components,
    /// dropped_components, several_components; each with its count.
    std::vector<mesh::MeshWarning> warnings;
    /// How the inside was found: `winding` (all parts closed: exact), `winding+voting` (some parts
    /// open), `voting` (all parts open), `surface` (nothing is enclosed: sheets and wires only),
    /// `touched` (dense_surface).
    std::string method;
    /// What finding the inside has cost: follows from mesh and options alone; a few nanoseconds
    /// each. Ordinary models stay below some millions.
    std::uint64_t work = 0;
};

/// What of the mesh counts, as voxelize takes it. @param axes  null for the canonical pose
[[nodiscard]] mesh::BodyOptions body_options(const VoxelizeOptions& options,
                                             const std::optional<Mat3>& axes);

/// Adds to the warnings that pieces were left out before the grid was laid: dropped_components.
void warn_of_pieces_apart(const mesh::Body& body, std::vector<mesh::MeshWarning>& warnings);

/// Turns any mesh into a solid volume. Faces without area and small pieces that lie apart take no
/// part (mesh/body.h).
///
/// Closed parts (by shared edges) are exact: a voxel is set when its centre has a winding number
/// other than 0 with respect to some part, so overlapping and nested parts unite, whichever way
/// each of them faces; positions are exact to 2^-18 voxels. Open parts and polygon soups are filled
/// where the parities of lines in thirteen directions agree (Nooruddin & Turk, "Simplification and
/// repair of polygonal models using volumetric techniques", 2003, sec. 4.1; lines with an odd
/// number of crossings have met a hole and do not vote). Parts thinner than a voxel are kept
/// without adding anything where the inside shows already.
///
/// The result does not depend on the order of vertices, triangles or corners, nor on translation or
/// uniform scale as far as the coordinates represent them exactly.
///
/// Time and memory are bounded by the grid and, linearly, by the number of triangles: where lines
/// would cross more triangles than can be told apart, the surface itself is the solid, or as many
/// of its triangles as can be looked at in time. Errors: mesh_empty, mesh_no_extent (all points
/// coincide), solid_empty, invalid_argument (an option out of its range, coordinates that are not
/// finite), cancelled (`stop` was requested; looked at every few milliseconds).
Result<VoxelSolid> voxelize(const mesh::TriangleMesh& mesh, const VoxelizeOptions& options = {},
                            const std::stop_token& stop = {});

}  // namespace ossuary::voxel
