#include "tests/benchmarks/limbs.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "engine/matching/assignment.h"
#include "tests/support/random.h"

namespace ossuary::benchmarks {
namespace {

constexpr double kLeastLimb = 0.25;

LimbMatch match_in_frame(const LimbPlaces& few, const LimbPlaces& many, const Mat3& frame) {
    std::vector<float> costs;
    for (std::size_t i = 0; i < few.limbs.size(); ++i) {
        for (std::size_t j = 0; j < many.limbs.size(); ++j) {
            const double root = (frame * few.places[2 * i] - many.places[2 * j]).norm();
            const double tip = (frame * few.places[2 * i + 1] - many.places[2 * j + 1]).norm();
            costs.push_back(static_cast<float>(root + tip));
        }
    }
    matching::Assignment assignment;
    const auto partner = assignment.solve(costs, few.limbs.size(), many.limbs.size());
    LimbMatch match{frame, {partner.begin(), partner.end()}, 0.0};
    for (std::size_t i = 0; i < match.partner.size(); ++i) {
        match.cost += static_cast<double>(costs[i * many.limbs.size() + match.partner[i]]);
    }
    return match;
}

/// The rotation that lays matched limbs over each other.
Mat3 laid_over(const LimbPlaces& few, const LimbPlaces& many, const LimbMatch& match) {
    Mat3 covariance = Mat3::Zero();
    for (std::size_t i = 0; i < match.partner.size(); ++i) {
        for (std::size_t end = 0; end < 2; ++end) {
            covariance +=
                many.places[2 * match.partner[i] + end] * few.places[2 * i + end].transpose();
        }
    }
    const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const bool mirrors = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0;
    const Vec3 signs(1.0, 1.0, mirrors ? -1.0 : 1.0);
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

std::optional<Limb> limb_of(const skeleton::SkeletonGraph& skeleton, std::uint32_t index) {
    const skeleton::SkeletonGraph::Branch& branch = skeleton.branches[index];
    const bool free_a = skeleton.nodes[branch.a].degree == 1;
    const bool free_b = skeleton.nodes[branch.b].degree == 1;
    if (free_a == free_b || branch.points.size() < 3) return std::nullopt;
    Limb limb;
    limb.branch = index;
    limb.from_a = free_b;
    limb.root = free_b ? branch.points.front() : branch.points.back();
    limb.tip = free_b ? branch.points.back() : branch.points.front();
    limb.middle = branch.points[branch.points.size() / 2];
    return limb;
}

std::vector<std::uint32_t> limbs_of(const skeleton::SkeletonGraph& skeleton) {
    double longest = 0.0;
    for (const auto& branch : skeleton.branches) longest = std::max(longest, branch.length());
    std::vector<std::uint32_t> limbs;
    for (std::uint32_t b = 0; b < skeleton.branches.size(); ++b) {
        const bool long_enough = skeleton.branches[b].length() >= kLeastLimb * longest;
        if (long_enough && limb_of(skeleton, b)) limbs.push_back(b);
    }
    return limbs;
}

void split_limb(skeleton::SkeletonGraph& graph, Limb& limb) {
    const auto node = static_cast<std::uint32_t>(graph.nodes.size());
    skeleton::SkeletonGraph::Branch& inner = graph.branches[limb.branch];
    const std::size_t half = inner.points.size() / 2;
    skeleton::SkeletonGraph::Branch outer;
    const auto at = static_cast<std::ptrdiff_t>(half);
    if (limb.from_a) {
        outer = {node,
                 inner.b,
                 {inner.points.begin() + at, inner.points.end()},
                 {inner.radii.begin() + at, inner.radii.end()}};
        inner.points.resize(half + 1);
        inner.radii.resize(half + 1);
        inner.b = node;
    } else {
        outer = {inner.a,
                 node,
                 {inner.points.begin(), inner.points.begin() + at + 1},
                 {inner.radii.begin(), inner.radii.begin() + at + 1}};
        inner.points.erase(inner.points.begin(), inner.points.begin() + at);
        inner.radii.erase(inner.radii.begin(), inner.radii.begin() + at);
        inner.a = node;
    }
    graph.nodes.push_back({limb.middle, outer.radii.front(), 0.0, 2});
    limb.second = static_cast<std::uint32_t>(graph.branches.size());
    graph.branches.push_back(std::move(outer));
}

LimbPlaces::LimbPlaces(const skeleton::SkeletonGraph& skeleton,
                       const std::vector<std::uint32_t>& branches) {
    for (const std::uint32_t branch : branches) {
        const std::optional<Limb> limb = limb_of(skeleton, branch);
        if (!limb) continue;
        limbs.push_back(*limb);
        places.push_back(limb->root);
        places.push_back(limb->tip);
    }
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : places) middle += place / static_cast<double>(places.size());
    double square = 0.0;
    for (Vec3& place : places) square += (place -= middle).squaredNorm();
    const double size = std::sqrt(square / static_cast<double>(places.size()));
    for (Vec3& place : places) place /= size;
}

LimbMatch match_places(const LimbPlaces& few, const LimbPlaces& many) {
    constexpr int kFrames = 400;
    std::mt19937_64 random(1);
    LimbMatch best;
    for (int start = 0; start < kFrames; ++start) {
        const auto next = [&] { return 2.0 * test::next_unit(random) - 1.0; };
        const Eigen::Quaterniond turn(next(), next(), next(), next());
        Mat3 frame = Mat3::Identity();
        if (start > 0) frame = turn.normalized().toRotationMatrix();
        LimbMatch match;
        for (int round = 0; round < 6; ++round) {
            match = match_in_frame(few, many, frame);
            frame = laid_over(few, many, match);
        }
        if (match.cost < best.cost) best = std::move(match);
    }
    return best;
}

}  // namespace ossuary::benchmarks
