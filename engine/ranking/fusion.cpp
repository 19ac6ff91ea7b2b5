#include "engine/ranking/fusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace ossuary::ranking {
namespace {

/// What a component counts before build and pose are weighed: in the fusion, and for nearness.
struct ComponentWeights {
    std::string_view component;
    double skeleton = 0.0, hybrid = 0.0;  ///< by ranker
    double skeleton_nearness = 0.0, hybrid_nearness = 0.0;
};

/// `skeleton` without the layout: first tier of the ten classes .869; with 1, 2 and 3 of
/// it .874, .881 and .881, and the armadillo's poses are told from other models with an AUC of
/// .9999, .9999 and .9997. Before nearness, `hybrid` was flat near the optimum on the ten classes
/// (.884): halving or doubling any one weight changed it by less than one point.
/// Build and pose have no weight here: they tell bodies of a kind apart.
///
/// Nearness tells copies of a model from its likes, by descriptors that are means over several
/// grids, and views. A small change of the surface turns the tree over (its median distance to a
/// noisy copy is .43 of the mean one, that to the nearest other model .49) and moves these little
/// (pairs .07 against .20, layout .05 against .18).
constexpr std::array<ComponentWeights, kComponentCount> kWeights = {{
    {"skeleton", 5.0, 5.0, 0.0, 0.0},
    {"skeleton_pairs", 4.0, 2.5, 1.0, 1.0},
    {"skeleton_layout", 2.0, 1.0, 1.0, 1.0},
    {"views", 0.0, 4.0, 0.0, 2.0},
    {"surface_pairs", 0.0, 1.5, 0.0, 0.0},
    {"local_volume", 0.0, 1.0, 0.0, 0.0},
    {"radial_thickness", 0.0, 1.5, 0.0, 0.0},
    {"build"},
    {"pose"},
    {"size"},
}};
static_assert(
    [] {
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            if (kWeights[c].component != component_name(c)) return false;
        }
        return true;
    }(),
    "every component has its row, in their order");

constexpr ComponentValues column_of_weights(double ComponentWeights::*column) {
    ComponentValues values{};
    for (std::size_t c = 0; c < kComponentCount; ++c) values[c] = kWeights[c].*column;
    return values;
}

/// Of the tree edit distance's weight under `skeleton`, what stays where the skeleton tells
/// nothing.
constexpr double kLeastTreeShare = 0.5;
/// The share of their mean distance at which these make a pair count as near. Of 300 noisy and 300
/// decimated copies `skeleton` finds 257 and 275 without; with .05, .1, .15 and .3 277, 284, 285,
/// 285 and 288, 289, 289, 289, the first tier of the ten classes the same to .001.
constexpr double kNear = 0.15;
/// Of all components beside these: only equal models are at distance 0.
constexpr double kTrace = 0.001;
/// Deviations that a size e times as large is worth: a tenth more is two of them.
constexpr double kSizeDeviations = 20.0;
constexpr double kMostOfSize = 40.0;
/// No single component may say more than this many deviations.
constexpr double kMaxDeviations = 8.0;
/// Below this many deviations they count as a logarithm.
constexpr double kNearest = -3.0;

/// The mean of two models' weights, of sum 1.
ComponentValues shares(const ComponentValues& a, const ComponentValues& b) {
    ComponentValues shares{};
    double total = 0.0;
    for (std::size_t c = 0; c < kComponentCount; ++c) {
        shares[c] = 0.5 * (a[c] + b[c]);
        total += shares[c];
    }
    for (double& share : shares) share /= total;
    return shares;
}

/// Each component's weight times its distance over the mean.
ComponentValues ratios(const ComponentValues& distances, const FusionSide& a, const FusionSide& b,
                       const ComponentValues& weights) {
    ComponentValues result{};
    for (std::size_t c = 0; c < kComponentCount; ++c) {
        const double ratio = distances[c] * (0.5 / a.scale.mean[c] + 0.5 / b.scale.mean[c]);
        result[c] = weights[c] * std::min(ratio, 1.0 + kMaxDeviations);
    }
    return result;
}

double size_deviations(const ComponentValues& distances, const FusionSide& a, const FusionSide& b) {
    const double weight = 0.5 * (a.size + b.size);
    return weight * std::min(kSizeDeviations * distances[kSizeComponent], kMostOfSize);
}

/// What a skeleton's build says of how much it tells.
struct SkeletonBuild {
    double length = 0.0;      ///< over the scale
    double limb_share = 0.0;  ///< volume of tubes along the branches over the solid's
    double solid_volume = 0.0;
    double branches = 0.0;
    double tips = 0.0;
};

SkeletonBuild build_of(const matching::SkeletonDescriptor& skeleton) {
    SkeletonBuild build;
    build.solid_volume = std::max(static_cast<double>(skeleton.solid_volume), 1e-9);
    build.limb_share = static_cast<double>(skeleton.limb_volume) / build.solid_volume;
    build.branches = static_cast<double>(skeleton.branches.size());
    std::vector<int> degree(skeleton.nodes.size(), 0);
    for (const matching::SkeletonDescriptor::Branch& branch : skeleton.branches) {
        build.length += static_cast<double>(branch.length);
        ++degree[branch.a];
        ++degree[branch.b];
    }
    build.tips = static_cast<double>(std::count(degree.begin(), degree.end(), 1));
    return build;
}

/// From 0 at `low` to 1 at `high`.
double smooth_step(double x, double low, double high) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Deviations, the great ones cut off and the far negative ones compressed.
double bounded_deviations(double deviations) {
    if (deviations < kNearest) return kNearest - std::log1p(kNearest - deviations);
    return std::min(deviations, kMaxDeviations);
}

double sum_of(const ComponentValues& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

/// The share `t` of the weights goes to one component.
void give(ComponentValues& weights, std::size_t component, double t) {
    const double total = sum_of(weights);
    for (double& weight : weights) weight *= 1.0 - t;
    weights[component] += t * total;
}

/// Between build alone, the weights that tell kinds apart, and pose alone.
void weigh_pose(ComponentValues& weights, double pose) {
    if (pose < kDefaultPose) {
        give(weights, kBuildComponent, 1.0 - pose / kDefaultPose);
    } else {
        give(weights, kPoseComponent, (pose - kDefaultPose) / (1.0 - kDefaultPose));
    }
}

}  // namespace

double skeleton_information(const matching::SkeletonDescriptor& skeleton) {
    const SkeletonBuild build = build_of(skeleton);
    // A single limb as long as the square root of the area is a rod; a ball has no length at all.
    const double by_length = std::min(build.length, 1.0);
    const double by_branches = std::min(build.branches / 5.0, 1.0);
    const double telling = std::sqrt(by_length * by_branches);
    // Limbs are tubes: what they hold together is the solid. Sheets are more than their skeleton.
    const double of_limbs = smooth_step(build.limb_share, 0.45, 0.9);
    // A skeleton of very many tips has been spread over a sheet or a rough body.
    const double of_tips = 1.0 - 0.8 * smooth_step(build.tips, 14.0, 24.0);
    // Neither a compact body nor a thin sheet is built of limbs.
    const double compact = 1.0 - 0.8 * smooth_step(build.solid_volume, 0.040, 0.049);
    const double thin = smooth_step(build.solid_volume, 0.019, 0.030);
    return telling * of_limbs * of_tips * compact * thin;
}

FusionSide fusion_side(const descriptor::ModelDescriptor& model, const ModelScale& scale,
                       const RankOptions& options) {
    return fusion_side(skeleton_information(model.skeleton), scale, options);
}

FusionSide fusion_side(double information, const ModelScale& scale, const RankOptions& options) {
    FusionSide side{scale, {}, {}, options.size};
    if (options.ranker == RankerKind::kSkeleton) {
        side.weights = column_of_weights(&ComponentWeights::skeleton);
        side.nearness = column_of_weights(&ComponentWeights::skeleton_nearness);
        side.weights[0] *= kLeastTreeShare + (1.0 - kLeastTreeShare) * information;
    } else {
        side.weights = column_of_weights(&ComponentWeights::hybrid);
        side.nearness = column_of_weights(&ComponentWeights::hybrid_nearness);
        for (std::size_t c = 0; c < kSkeletonComponents; ++c) side.weights[c] *= information;
    }
    weigh_pose(side.weights, options.pose);
    weigh_pose(side.nearness, options.pose);
    return side;
}

double fused_distance(const ComponentValues& distances, const FusionSide& a, const FusionSide& b) {
    const ComponentValues weights = shares(a.weights, b.weights);
    double deviations = 0.0;
    for (std::size_t c = 0; c < kComponentCount; ++c) {
        const double from_a = (distances[c] - a.scale.mean[c]) / a.scale.deviation[c];
        const double from_b = (distances[c] - b.scale.mean[c]) / b.scale.deviation[c];
        deviations += weights[c] * bounded_deviations(0.5 * (from_a + from_b));
    }
    const double size = size_deviations(distances, a, b);
    const double near = sum_of(ratios(distances, a, b, shares(a.nearness, b.nearness))) / kNear;
    const double trace = kTrace * sum_of(ratios(distances, a, b, weights));
    return std::exp(deviations + size) * -std::expm1(-(near * near + trace + size * size));
}

ComponentValues fused_parts(const ComponentValues& distances, const FusionSide& a,
                            const FusionSide& b) {
    ComponentValues parts = ratios(distances, a, b, shares(a.weights, b.weights));
    parts[kSizeComponent] = size_deviations(distances, a, b);
    const double sum = sum_of(parts);
    if (sum <= 0.0) return {};
    const double scale = fused_distance(distances, a, b) / sum;
    for (double& part : parts) part *= scale;
    return parts;
}

}  // namespace ossuary::ranking
