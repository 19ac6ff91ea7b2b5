#pragma once

#include <span>
#include <stop_token>
#include <string_view>

#include "engine/core/geometry.h"
#include "engine/core/result.h"
#include "engine/skeleton/skeleton_graph.h"
#include "engine/skeleton/smooth.h"

namespace ossuary::skeleton {

enum class PruningMethod {
    kProtrusion,    ///< ours: reach against the junction's radius
    kSignificance,  ///< the thesis: eq. 3.3 against the mean significance (sec. 3.2.3)
    kNone,
};

[[nodiscard]] std::string_view to_string(PruningMethod method);
Result<PruningMethod> parse_pruning_method(std::string_view name);

/// Parameters of the seven refinement steps of sec. 3.2.4.
struct RefineOptions {
    PruningMethod pruning = PruningMethod::kProtrusion;
    double min_protrusion = 1.6;  ///< protrusion: reach / junction radius below which a branch goes
    int max_leaves = 24;          ///< protrusion: raise the threshold until at most this many
    bool merge_junctions = true;  ///< contract inner branches shorter than the larger end radius
    double significance_scale = 2.0;  ///< significance: t_k of the pruning threshold
    bool significance = true;         ///< in the results; without it they do not stand for eq. 3.3
    bool smooth = true;
    double presmooth_variance = 4.0;  ///< t of the pre-pass (points squared)
    double max_variance = 400.0;      ///< upper limit of the adaptive t_k of eq. 3.4
    SmoothingScale smoothing_scale = SmoothingScale::kBendingSum;  ///< reading of t_k
};

struct RefinedSkeleton {
    SkeletonGraph pruned;
    SkeletonGraph refined;
};

/// The seven steps of sec. 3.2.4 on a skeleton in voxel units: decompose, significance (eq. 3.3),
/// prune, re-decompose, bending (eq. 3.4), adaptive Gaussian (eq. 3.1-3.2). Both results carry
/// degrees and, unless declined, significances; neither has lost a cycle or a component.
/// Not complete when stopped.
/// @param surface  points of the model's surface in the same (grid) coordinates, for eq. 3.3
RefinedSkeleton refine(const SkeletonGraph& thinned, std::span<const Vec3> surface,
                       const RefineOptions& options = {}, const std::stop_token& stop = {});

}  // namespace ossuary::skeleton
