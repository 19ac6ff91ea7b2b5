#include "engine/matching/match_part.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "engine/matching/node_clusters.h"

namespace ossuary::matching {
namespace {

SampledTree whole_tree(const PartQuery& part, const SkeletonDescriptor& whole) {
    SampleTreeOptions options;
    options.step = part.options().step;
    return sample_tree(whole, options);
}

struct Best {
    double distance = 1.0;
    std::size_t candidate = 0;
};

/// Small copies of a part fit everywhere.
double size_cost(const PartMatchOptions& options, double scale) {
    return options.shrinking * std::log2(options.largest / scale);
}

double distance_at(const PartQuery& part, std::size_t index, const SampledTree& whole,
                   PartEdit& edit, PartEdit::Place& place) {
    const PartMatchOptions& options = part.options();
    const PartQuery::Candidate& candidate = part.candidates()[index];
    const PartEditCosts& costs = options.costs;
    place = edit.solve(candidate.tree, whole, costs);
    const double share = static_cast<double>(place.cost) / (costs.removal * candidate.length);
    return std::min(1.0, share + size_cost(options, candidate.scale));
}

Best find_best(const PartQuery& part, const SampledTree& whole, PartEdit& edit) {
    Best best;
    PartEdit::Place place;
    for (std::size_t i = 0; i < part.candidates().size(); ++i) {
        const double distance = distance_at(part, i, whole, edit, place);
        if (distance < best.distance) best = {distance, i};
    }
    return best;
}

/// What is found of a part in a model at the best size.
struct Found {
    const SampledTree& part;
    const SampledTree& whole;
    PartEdit::Place place;
    std::vector<PartEdit::Pair> pairs;
};

/// Nodes are matched where two pieces that end at nodes are exchanged, and at the top.
void add_nodes(const Found& found, const PartEdit& edit, Correspondence& match) {
    const std::uint32_t part_top = found.part.tops[found.place.part_top].graph_node;
    const std::uint32_t whole_top = found.place.at_top
                                        ? found.whole.tops[found.place.whole_top].graph_node
                                        : found.whole.nodes[found.place.whole_top].graph_node;
    if (whole_top != kNoIndex && !found.pairs.empty()) {
        match.nodes.push_back({part_top, whole_top, 0.0});
    }
    for (const auto& [i, j] : found.pairs) {
        const SampledTree::Node& p = found.part.nodes[i];
        const SampledTree::Node& w = found.whole.nodes[j];
        if (p.graph_node == kNoIndex || w.graph_node == kNoIndex) continue;
        match.nodes.push_back({p.graph_node, w.graph_node, static_cast<double>(edit.rate(p, w))});
    }
}

/// Branches of which pieces are exchanged, with the mean cost.
/// @return the cost of all exchanges
double add_branches(const Found& found, const PartEdit& edit, Correspondence& match) {
    struct Sum {
        double cost = 0.0;
        double length = 0.0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sum> sums;
    double total = 0.0;
    for (const auto& [i, j] : found.pairs) {
        const SampledTree::Node& p = found.part.nodes[i];
        const SampledTree::Node& w = found.whole.nodes[j];
        const double length = static_cast<double>(p.length) + w.length;
        const double cost = static_cast<double>(edit.rate(p, w)) * length;
        Sum& sum = sums[{p.branch, w.branch}];
        sum.cost += cost;
        sum.length += length;
        total += cost;
    }
    for (const auto& [pair, sum] : sums) {
        match.branches.push_back(
            {pair.first, pair.second, sum.length > 0.0 ? sum.cost / sum.length : 0.0});
    }
    return total;
}

/// Matched nodes hang together over branches of the part that are matched too.
void add_clusters(const PartQuery& part, Correspondence& match) {
    NodeClusters clusters(part.node_count());
    std::vector<bool> matched(part.node_count(), false);
    for (const Correspondence::Pair& pair : match.nodes) {
        clusters.add(pair.a);
        matched[pair.a] = true;
    }
    for (const Correspondence::Pair& pair : match.branches) {
        const auto [a, b] = part.branches()[pair.a];
        if (matched[a] && matched[b]) clusters.join(a, b);
    }
    match.cluster_sizes = clusters.sizes();
}

}  // namespace

PartQuery::PartQuery(const SkeletonDescriptor& part, const PartMatchOptions& options,
                     const std::stop_token& stop)
    : options_(options), node_count_(part.nodes.size()) {
    for (const SkeletonDescriptor::Branch& branch : part.branches) {
        branches_.emplace_back(branch.a, branch.b);
    }
    assert(options.step > 0.0 && options.largest > 0.0 && options.ratio > 0.0);
    SampleTreeOptions sample;
    sample.step = options.step;
    sample.every_top = true;
    sample.scale = options.largest;
    for (int i = 0; i < options.candidates && !stop.stop_requested(); ++i) {
        Candidate candidate;
        candidate.scale = sample.scale;
        candidate.tree = sample_tree(part, sample, stop);
        for (const SampledTree::Top& top : candidate.tree.tops) {
            candidate.length = std::max(candidate.length, static_cast<double>(top.length));
        }
        if (candidate.length > 0.0) candidates_.push_back(std::move(candidate));
        sample.scale *= options.ratio;
    }
}

double part_distance(const PartQuery& part, const SkeletonDescriptor& whole, PartEdit& workspace) {
    if (part.empty()) return 0.0;
    const SampledTree tree = whole_tree(part, whole);
    if (tree.tops.empty()) return 1.0;
    return find_best(part, tree, workspace).distance;
}

Match match_part(const PartQuery& part, const SkeletonDescriptor& whole,
                 const std::stop_token& stop) {
    Match match;
    if (part.empty()) return match;
    const SampledTree tree = whole_tree(part, whole);
    PartEdit edit(stop);
    const Best best = tree.tops.empty() ? Best{} : find_best(part, tree, edit);
    match.distance = best.distance;
    if (best.distance >= 1.0 || stop.stop_requested()) {
        match.parts = {{"exchanged", 0.0}, {"size", 0.0}, {"unmatched", 1.0}};
        return match;
    }
    // The buffers hold the last candidate: solved again for the best.
    const PartQuery::Candidate& candidate = part.candidates()[best.candidate];
    Found found{candidate.tree, tree, {}, {}};
    distance_at(part, best.candidate, tree, edit, found.place);
    if (stop.stop_requested()) return match;
    edit.exchanged(candidate.tree, tree, found.place, found.pairs);
    add_nodes(found, edit, match.correspondence);
    const double exchanged = add_branches(found, edit, match.correspondence) /
                             (part.options().costs.removal * candidate.length);
    add_clusters(part, match.correspondence);
    const double size = size_cost(part.options(), candidate.scale);
    match.parts = {{"exchanged", exchanged},
                   {"size", size},
                   {"unmatched", std::max(0.0, match.distance - exchanged - size)}};
    return match;
}

}  // namespace ossuary::matching
