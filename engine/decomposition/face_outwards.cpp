#include "engine/decomposition/face_outwards.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/decomposition/branch_mapping.h"

namespace ossuary::decomposition {
namespace {

/// The mean cosine between the surface and the way from the skeleton that is taken for an answer.
constexpr double kDecisive = 0.2;
/// Triangles of one patch that are asked.
constexpr std::size_t kAsked = 1000;

struct Vote {
    double sum = 0.0;
    double area = 0.0;
    std::size_t seen = 0;  ///< triangles of the patch so far
};

}  // namespace

void face_outwards(mesh::MendedSurface& surface, const skeleton::SkeletonGraph& skeleton) {
    const auto is_open = [](const mesh::OrientedPatch& patch) { return !patch.closed; };
    if (skeleton.branches.empty() ||
        std::none_of(surface.patches.begin(), surface.patches.end(), is_open)) {
        return;
    }
    const BranchMapping mapping(skeleton);
    std::vector<Vote> votes(surface.patches.size());
    for (std::size_t t = 0; t < surface.patch_of.size(); ++t) {
        const mesh::OrientedPatch& patch = surface.patches[surface.patch_of[t]];
        if (patch.closed) continue;
        Vote& vote = votes[surface.patch_of[t]];
        const std::size_t stride = (patch.triangles + kAsked - 1) / kAsked;
        if (vote.seen++ % stride != 0) continue;
        const auto [a, b, c] = surface.mesh.corners(t);
        const Vec3 normal = (b - a).cross(c - a);
        const Vec3 center = (a + b + c) / 3.0;
        vote.sum += (center - mapping.nearest(center)).stableNormalized().dot(normal);
        vote.area += normal.norm();
    }
    std::vector<bool> chosen(votes.size(), false);
    for (std::size_t p = 0; p < votes.size(); ++p) {
        if (!(std::abs(votes[p].sum) > kDecisive * votes[p].area)) continue;
        surface.patches[p].sure = true;
        chosen[p] = votes[p].sum < 0.0;
    }
    mesh::turn_over(surface, chosen);
}

}  // namespace ossuary::decomposition
