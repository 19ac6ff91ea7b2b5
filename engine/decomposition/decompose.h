#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/stopwatch.h"
#include "engine/decomposition/pair_features.h"
#include "engine/decomposition/patches.h"
#include "engine/decomposition/segmentation.h"
#include "engine/decomposition/surface_graph.h"
#include "engine/mesh/mend_surface.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/skeleton/skeletonize.h"

namespace ossuary::decomposition {

/// The skeleton that a decomposition asks: coarser than retrieval's, which costs a third of the
/// time and leaves the Rand index error where it is, and without significances, which nothing of it
/// looks at.
[[nodiscard]] skeleton::SkeletonizeOptions decomposition_skeleton_options();

enum class DecompositionMethod {
    kEvidence,  ///< ours: patches merged where people would
    kThesis,    ///< one part a branch of the skeleton (thesis sec. 3.4; map_surface.h)
};

[[nodiscard]] std::string_view to_string(DecompositionMethod method);
Result<DecompositionMethod> parse_decomposition_method(std::string_view name);

struct DecomposeOptions {
    DecompositionMethod method = DecompositionMethod::kEvidence;
    /// evidence: the number of parts wanted; 0 leaves it to the evidence.
    std::size_t parts = 0;
    std::uint64_t seed = 1;     ///< thesis: of the sampled points
    std::size_t patches = 160;  ///< evidence: that parts are made of
    skeleton::SkeletonizeOptions skeletonize = decomposition_skeleton_options();
};
inline constexpr std::size_t kMaxParts = 100;

struct Decomposition {
    struct Part {
        std::size_t triangles = 0;
        double area = 0.0;         ///< model units squared; of faces that come twice, once
        std::int32_t branch = -1;  ///< of `skeleton` that most of it belongs to; -1 without one
        std::vector<std::uint32_t> neighbors;  ///< parts that share a border with it, ascending
    };
    Segmentation segmentation;  ///< the part of each triangle of the mesh
    /// What was cut: the mesh with its seams joined, each face once, facing outwards.
    mesh::MendedSurface surface;
    Segmentation on_surface;  ///< the part of each triangle of `surface.mesh`
    std::vector<Part> parts;
    skeleton::SkeletonGraph skeleton;  ///< refined, in model units
    std::vector<mesh::MeshWarning> warnings;
    StageTimes stage_times;
};

/// A model's surface and what is inside it.
struct SurfaceAndSkeleton {
    mesh::MendedSurface mended;
    skeleton::Skeleton skeleton;
    skeleton::SkeletonGraph refined;  ///< that of `skeleton` in model units
    SurfaceGraph surface;             ///< of `mended.mesh`
    StageTimes stage_times;
};
/// Open patches of the surface are turned to face away from the skeleton (face_outwards.h).
/// Errors: those of skeletonize.
Result<SurfaceAndSkeleton> surface_and_skeleton(mesh::MendedSurface surface,
                                                const DecomposeOptions& options,
                                                std::stop_token stop = {});

/// The same with its patches and all that was measured of them: what decompose decides by.
struct MeasuredPatches : SurfaceAndSkeleton {
    PatchGraph graph;
    PatchPairs pairs;
};
/// Errors: those of skeletonize; invalid_argument (more parts wanted than there are faces).
Result<MeasuredPatches> measure_patches(mesh::MendedSurface surface,
                                        const DecomposeOptions& options = {},
                                        std::stop_token stop = {});

/// Cuts a surface into the parts that people would see: small patches are told apart or put
/// together by thickness, concave creases, ways along the surface, through the solid and along the
/// skeleton (affinity.h), merged where that makes the expected Rand index largest
/// (merge_patches.h), and the borders laid into the creases (refine_borders.h); what
/// remains too small is joined (small_parts.h). All this looks at
/// the mended surface (mend_surface.h), so that it makes no difference how the faces lie; every
/// triangle of the mesh gets the part of the one that stands for it there. Where
/// a number of parts is asked for, none runs through a face, so that each has faces of its own.
/// Parts are connected, but for small pieces of a soup, and numbered by descending area.
/// Deterministic. `method` may ask for the thesis' algorithm instead, whose parts need not be
/// connected.
/// Warnings: those of voxelize and of mending.
/// Errors: those of skeletonize; invalid_argument (more than kMaxParts parts wanted, more than the
/// surface has faces, or a number of parts wanted of the thesis' algorithm).
Result<Decomposition> decompose(const mesh::TriangleMesh& mesh,
                                const DecomposeOptions& options = {}, std::stop_token stop = {});

/// The same of a mesh that has been mended.
Result<Decomposition> decompose(mesh::MendedSurface surface, const DecomposeOptions& options = {},
                                std::stop_token stop = {});

/// The part of each face of the file that the mesh was read from: that of most of the face's area;
/// part 0 for faces that gave no triangle.
[[nodiscard]] Segmentation face_segmentation(const mesh::TriangleMesh& mesh,
                                             const Segmentation& triangles);

/// The other way round: each triangle's part is that of its face.
[[nodiscard]] Segmentation triangle_segmentation(const mesh::TriangleMesh& mesh,
                                                 const Segmentation& faces);

}  // namespace ossuary::decomposition
