#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/triangle_mesh.h"
#include "engine/registration/local_features.h"
#include "engine/registration/similarity.h"
#include "engine/registration/surface_points.h"

/// Finding wholes that a piece may have been cut from, whatever its size and place.
namespace ossuary::registration {

/// What is kept of a model, so that pieces of it can be found.
struct WholeFeatures {
    LocalFeatures features;
    double area = 0.0;  ///< of the surface, model units squared
};

/// @param mesh  with area; else there are no features
[[nodiscard]] WholeFeatures whole_features(const mesh::TriangleMesh& mesh);

/// A piece as it is looked for.
struct PieceQuery {
    SurfacePoints surface;
    LocalFeatures features;
    SurfacePoints checked;  ///< fewer points, to see how much of the piece lies in a whole
};

[[nodiscard]] PieceQuery piece_query(const mesh::TriangleMesh& mesh);

/// How near the nearest feature of a whole is to each of some of the piece's (piece_distance,
/// rooted, in steps of 1/50); the greatest number everywhere for a whole without features.
[[nodiscard]] std::vector<std::uint16_t> nearest_features(const PieceQuery& piece,
                                                          const WholeFeatures& whole);

/// How much each of many wholes looks as if it had the piece, in [0, 1], before any is placed: each
/// feature of the piece speaks for the wholes that have one nearer to it than all but three and a
/// twentieth of the others, by how much nearer (McCann and Lowe, Local Naive Bayes Nearest Neighbor
/// for Image Classification, 2012). 1 is the most of all.
/// @param nearest  `nearest_features` of each whole
[[nodiscard]] std::vector<double> piece_likeness(
    std::span<const std::vector<std::uint16_t>> nearest);

/// A whole's surface as pieces are held against it.
class WholeSurface {
public:
    explicit WholeSurface(const mesh::TriangleMesh& mesh);

    [[nodiscard]] bool empty() const { return surface_.points.empty(); }
    [[nodiscard]] const SurfacePoints& surface() const { return surface_; }
    [[nodiscard]] const NearestPoint& nearest() const { return nearest_; }

private:
    SurfacePoints surface_;
    NearestPoint nearest_;
};

struct PiecePlacement {
    Similarity placement;    ///< of the piece in the whole, model units
    double explained = 0.0;  ///< share of the piece's area that lies on the whole, facing its way
    double distance =
        1.0;  ///< of the piece from the whole, in [0, 1]; 0 = it lies there but for a fifth
};

/// The best place for a piece in a whole: candidates from local features (feature_candidates.h),
/// refined by iterated closest points; the one that most of the piece agrees with. A piece covers
/// at least 3 % of the whole's area and is not larger than it by more than a fifth; the fifth of it
/// that lies farthest off (the cap over a cut) does not count. None where no features agree.
[[nodiscard]] std::optional<PiecePlacement> place_piece(const PieceQuery& piece,
                                                        const WholeFeatures& whole,
                                                        const WholeSurface& surface);

/// A place, refined with more of the piece and measured by the whole's exact surface: tells apart
/// wholes in which the piece lies nearly as well. `distance` is then comparable only with those of
/// other settled places. The place as it was where refining leads too far away.
/// @param mesh  of the whole, with area
[[nodiscard]] PiecePlacement settle_piece(const PieceQuery& piece, const mesh::TriangleMesh& mesh,
                                          const PiecePlacement& placed);

}  // namespace ossuary::registration
