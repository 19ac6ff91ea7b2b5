#include "engine/matching/pose_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ossuary::matching {
namespace {

/// Limbs whose lengths differ by more are never taken for each other.
constexpr float kLikeLength = 1.35F;
constexpr int kRounds = 4;

/// A node with what is compared of it.
struct Site {
    Vec3f node = Vec3f::Zero();
    Vec3f middle = Vec3f::Zero();  ///< of the limb that ends here; the node where none does
    float limb = 0.0F;             ///< length of that limb; 0 at junctions
};

std::vector<Site> sites_of(const SkeletonDescriptor& skeleton) {
    std::vector<Site> sites(skeleton.nodes.size());
    std::vector<int> degree(sites.size(), 0);
    for (const SkeletonDescriptor::Branch& branch : skeleton.branches) {
        ++degree[branch.a];
        ++degree[branch.b];
    }
    for (std::size_t i = 0; i < sites.size(); ++i) {
        sites[i].node = Vec3f(skeleton.nodes[i].position.data());
        sites[i].middle = sites[i].node;
    }
    for (const SkeletonDescriptor::Branch& branch : skeleton.branches) {
        const Vec3f middle(&branch.points[3 * (branch.radii.size() / 2)]);
        for (const std::uint32_t end : {branch.a, branch.b}) {
            if (degree[end] != 1) continue;
            sites[end].middle = middle;
            sites[end].limb = branch.length;
        }
    }
    return sites;
}

/// The straight distances between two sites: of their nodes and of their middles.
float difference(const Site& a, const Site& b, const Site& other_a, const Site& other_b) {
    return std::abs((a.node - b.node).norm() - (other_a.node - other_b.node).norm()) +
           std::abs((a.middle - b.middle).norm() - (other_a.middle - other_b.middle).norm());
}

float sum(const Site& a, const Site& b) {
    return (a.node - b.node).norm() + (a.middle - b.middle).norm();
}

bool alike(const Site& a, const Site& b) {
    if (a.limb <= 0.0F || b.limb <= 0.0F) return false;
    return std::max(a.limb, b.limb) <= kLikeLength * std::min(a.limb, b.limb);
}

/// Pairs of sites, each of one skeleton with one of the other.
class Arrangement {
public:
    Arrangement(std::vector<Site> a, std::vector<Site> b) : a_(std::move(a)), b_(std::move(b)) {}

    /// Exchanges the partners of like limbs as long as that makes the two stand more alike.
    void settle(const std::stop_token& stop) {
        for (int round = 0; round < kRounds; ++round) {
            bool changed = false;
            for (std::size_t k = 0; k < a_.size(); ++k) {
                for (std::size_t l = k + 1; l < a_.size(); ++l) {
                    if (stop.stop_requested()) return;
                    changed |= try_exchange(k, l);
                }
            }
            if (!changed) return;
        }
    }

    [[nodiscard]] double distance() const {
        double differences = 0.0, sums = 0.0;
        for (std::size_t k = 0; k < a_.size(); ++k) {
            for (std::size_t l = k + 1; l < a_.size(); ++l) {
                differences += static_cast<double>(difference(a_[k], a_[l], b_[k], b_[l]));
                sums += static_cast<double>(sum(a_[k], a_[l])) + sum(b_[k], b_[l]);
            }
        }
        return sums > 0.0 ? differences / sums : 0.0;
    }

private:
    bool try_exchange(std::size_t k, std::size_t l) {
        if (!alike(a_[k], b_[l]) || !alike(a_[l], b_[k])) return false;
        float gain = 0.0F;
        for (std::size_t other = 0; other < a_.size(); ++other) {
            if (other == k || other == l) continue;
            gain += difference(a_[k], a_[other], b_[k], b_[other]) +
                    difference(a_[l], a_[other], b_[l], b_[other]) -
                    difference(a_[k], a_[other], b_[l], b_[other]) -
                    difference(a_[l], a_[other], b_[k], b_[other]);
        }
        if (gain <= 1e-5F) return false;
        std::swap(b_[k], b_[l]);
        return true;
    }

    std::vector<Site> a_, b_;
};

}  // namespace

double pose_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                     const Correspondence& match, const std::stop_token& stop) {
    // In the order that the matching itself keeps, so that both ways give the same bits.
    const bool swapped = a.rooted.content_key > b.rooted.content_key;
    const std::vector<Site> sites_a = sites_of(swapped ? b : a);
    const std::vector<Site> sites_b = sites_of(swapped ? a : b);
    std::vector<Site> first, second;
    for (const Correspondence::Pair& pair : match.nodes) {
        first.push_back(sites_a[swapped ? pair.b : pair.a]);
        second.push_back(sites_b[swapped ? pair.a : pair.b]);
    }
    Arrangement arrangement(std::move(first), std::move(second));
    arrangement.settle(stop);
    return arrangement.distance();
}

double pose_distance(const SkeletonDescriptor& a, const SkeletonDescriptor& b,
                     const SkeletonMatchOptions& options, const std::stop_token& stop) {
    return pose_distance(a, b, match_skeletons(a, b, options, stop).correspondence, stop);
}

}  // namespace ossuary::matching
