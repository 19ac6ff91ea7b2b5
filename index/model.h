#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/decomposition/decompose.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/registration/piece_search.h"
#include "engine/skeleton/skeleton_graph.h"
#include "engine/skeleton/thinning.h"
#include "index/up.h"

namespace ossuary::index {

/// A model's number in its index: given in the order of indexing, from 1, never used twice.
using ModelId = std::int64_t;

/// Raised whenever the same file would be described differently; an index that was built with
/// another version has to be built again.
inline constexpr int kPipelineVersion = 6;
/// Earlier ones left models without parts.
inline constexpr int kFirstPipelineWithSegments = 4;

/// How the models of an index were described. All of one index are described alike, and queries
/// like them, so these are fixed when an index is made.
struct IndexParameters {
    int resolution = 96;  ///< voxels along the longest side
    skeleton::ThinningMethod thinning = skeleton::ThinningMethod::kAnchored;
    int pipeline = kPipelineVersion;

    bool operator==(const IndexParameters&) const = default;
};

/// The stages' options that `parameters` stand for, with all threads of the machine for one model.
[[nodiscard]] descriptor::DescribeOptions describe_options(const IndexParameters& parameters);

/// Which way a model stands: by what axis of its file, and whether a person has said so or the
/// program found it. Only pictures and viewers ask.
struct Orientation {
    Up up = Up::kY;
    bool said_by_person = false;

    bool operator==(const Orientation&) const = default;
};

/// What a model's file, or its format, says of its coordinates.
struct FileFrame {
    double metres_per_unit = 0.0;  ///< 0 where it names no unit
    std::optional<Up> up;

    bool operator==(const FileFrame&) const = default;
};

/// What lists and pages show of a model.
struct ModelSummary {
    ModelId id = 0;
    std::string name;          ///< file name without folder and extension, e.g. "elephant"
    std::string class_name;    ///< empty where no class is known
    std::string path;          ///< absolute; empty for a model that was uploaded
    std::string content_hash;  ///< XXH3-128 of the file's bytes, 32 hexadecimal digits
    std::uint32_t vertices = 0;
    std::uint32_t faces = 0;     ///< polygons in the file
    std::uint32_t nodes = 0;     ///< of the refined skeleton
    std::uint32_t branches = 0;  ///< of the refined skeleton
    Box3 bounds;                 ///< model units
    double surface_area = 0.0;   ///< model units squared
    Orientation orientation;
    FileFrame frame;
    std::vector<mesh::MeshWarning> warnings;
    std::string indexed_at;  ///< ISO 8601, UTC, e.g. 2026-01-01T00:00:00Z
};

/// The colours of a preview, sRGB.
struct PreviewColours {
    enum class Of : std::uint8_t {
        kNothing,    ///< the file has none
        kModel,      ///< one for all
        kVertices,   ///< between which they run evenly
        kTriangles,  ///< each of one colour
        kCorners,    ///< three for each triangle, between which they run evenly
    };
    Of of = Of::kNothing;
    std::vector<std::uint8_t> bytes;  ///< red, green, blue of each

    bool operator==(const PreviewColours&) const = default;
};

/// A coarse copy of a model for viewers: at most about 2000 triangles.
struct PreviewMesh {
    /// From where positions are counted, model units: the middle of the bounds, since floats about
    /// the file's origin cannot tell the vertices of a model that lies far from it apart.
    Vec3 origin = Vec3::Zero();
    std::vector<float> positions;          ///< x y z a vertex from `origin`, model units
    std::vector<std::uint32_t> triangles;  ///< three vertex indices a triangle
    PreviewColours colours;
};

/// The parts of a model: those of the whole mesh, and where they are on the preview.
struct ModelSegments {
    /// By descending area. Area and neighbours are those of the whole mesh, `triangles` counts
    /// those of the preview, `branch` is one of the stored skeleton.
    std::vector<decomposition::Decomposition::Part> parts;
    /// The part of each triangle of the preview; every part has one.
    std::vector<std::uint32_t> labels;
};

/// A model's refined skeleton in model units, with the 5-element chain code of each branch.
struct StoredSkeleton {
    skeleton::SkeletonGraph graph;
    std::vector<std::string> chain_codes;  ///< as long as graph.branches
};

/// All that the index keeps of one model. `summary.id`, `nodes`, `branches` and `indexed_at` are
/// set by the store.
struct NewModel {
    ModelSummary summary;
    descriptor::ModelDescriptor descriptor;
    skeleton::SkeletonGraph
        skeleton;  ///< refined, model units; indices as in `descriptor.skeleton`
    PreviewMesh preview;
    /// None where the model could not be cut into parts; then the warning kSegmentsMissing says
    /// why.
    std::optional<ModelSegments> segments;
    registration::WholeFeatures features;  ///< of the preview; none where that has no area
    std::vector<std::uint8_t> thumbnail;   ///< PNG; empty where none could be drawn
};

inline constexpr std::string_view kSegmentsMissing = "segments_missing";

/// A file that could not be indexed, and why.
struct Failure {
    std::string path;
    std::string content_hash;  ///< empty where the file could not be read
    std::string code;          ///< name of an ErrorCode
    std::string message;
    std::string failed_at;  ///< ISO 8601, UTC
};

}  // namespace ossuary::index
