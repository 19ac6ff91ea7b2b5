#pragma once

#include <vector>

#include "engine/skeleton/skeleton_graph.h"

namespace ossuary::skeleton {

/// How eq. 3.4 sets a branch's scale t_k, with n its number of points and F its bending. Thesis
/// sec. 3.2.4 writes "t_k = 1 / F * n, so t_k = (sum of sines) / 2", which are two different
/// things.
enum class SmoothingScale {
    kBendingSum,  ///< t_k = F * n, half the sum of sines: the second; bent branches smoothed most
    kQuotient,    ///< t_k = n / F, the first; straight branches smoothed most
    kFixed,       ///< no second pass
};

/// Eq. 3.4: the mean over the branch's points of (sin theta_s + sin theta_e) / 2, where theta_s is
/// the angle at the branch's start between the directions to its end and to the point, theta_e the
/// like at its end; 0 for a straight branch. A closed branch is measured as two halves.
double bending(const SkeletonGraph::Branch& branch);

/// The scale t_k of a branch by eq. 3.4, at most `max_variance`; for a closed branch that of a
/// half.
double smoothing_variance(const SkeletonGraph::Branch& branch, SmoothingScale scale,
                          double max_variance);

/// Eq. 3.1-3.2 on one branch: each coordinate and the radius, as functions of the point's number,
/// convolved with a Gaussian of variance `variance` (in points squared). The branch is continued
/// beyond its ends by reflection in them, which holds the end points where they are, so that
/// branches stay attached to their junctions and straight branches stay straight.
void smooth_branch(SkeletonGraph::Branch& branch, double variance);

/// The same for a closed curve without a junction: periodic, so that its node moves as well; it is
/// written to `node`.
void smooth_closed_branch(SkeletonGraph::Branch& branch, SkeletonGraph::Node& node,
                          double variance);

}  // namespace ossuary::skeleton
