#include "engine/decomposition/registered_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace ossuary::decomposition {
namespace {

/// Finds which vertices hang together within one pair of parts.
class VertexSets {
public:
    std::uint32_t root(std::uint32_t vertex) {
        const auto [entry, is_new] = parent_.try_emplace(vertex, vertex);
        if (is_new || entry->second == vertex) return vertex;
        return entry->second = root(entry->second);
    }
    void unite(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

private:
    std::map<std::uint32_t, std::uint32_t> parent_;
};

using PartPair = std::pair<std::uint32_t, std::uint32_t>;

void enclose(Cut& cut) {
    for (const Vec3& node : cut.nodes) cut.center += node;
    cut.center /= static_cast<double>(cut.nodes.size());
    for (const Vec3& node : cut.nodes) {
        cut.radius = std::max(cut.radius, (node - cut.center).norm());
    }
}

double mean_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double sum = 0.0;
    for (const Vec3& node : from) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& other : to) nearest = std::min(nearest, (node - other).squaredNorm());
        sum += std::sqrt(nearest);
    }
    return sum / static_cast<double>(from.size());
}

struct Candidate {
    double distance = 0.0;
    std::size_t reference = 0;
    std::size_t made = 0;
    bool operator<(const Candidate& other) const {
        return std::tie(distance, reference, made) <
               std::tie(other.distance, other.reference, other.made);
    }
};

}  // namespace

std::vector<Cut> find_cuts(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& edges,
                           const Segmentation& segmentation) {
    std::map<PartPair, std::vector<const mesh::EdgeTable::Edge*>> between;
    for (const mesh::EdgeTable::Edge& edge : edges.edges) {
        const auto sides = edges.sides_of(edge);
        if (sides.size() != 2) continue;
        const auto [low, high] =
            std::minmax({segmentation.labels[sides[0] / 3], segmentation.labels[sides[1] / 3]});
        if (low != high) between[{low, high}].push_back(&edge);
    }
    std::vector<std::pair<const mesh::EdgeTable::Edge*, Cut>> found;
    for (const auto& [parts, members] : between) {
        VertexSets sets;
        for (const mesh::EdgeTable::Edge* edge : members) sets.unite(edge->a, edge->b);
        std::map<std::uint32_t, std::size_t> cut_of_set;
        for (const mesh::EdgeTable::Edge* edge : members) {
            const auto [entry, is_new] = cut_of_set.try_emplace(sets.root(edge->a), found.size());
            if (is_new) found.emplace_back(edge, Cut{});
            Cut& cut = found[entry->second].second;
            const Vec3 &a = mesh.vertices[edge->a], &b = mesh.vertices[edge->b];
            cut.nodes.push_back(0.5 * (a + b));
            cut.length += (b - a).norm();
        }
    }
    // Both pointers are into one array: the order is that of the edges.
    std::sort(found.begin(), found.end(),
              [](const auto& x, const auto& y) { return x.first < y.first; });
    std::vector<Cut> cuts;
    for (auto& [edge, cut] : found) {
        enclose(cut);
        cuts.push_back(std::move(cut));
    }
    return cuts;
}

RegisteredCuts register_cuts(const std::vector<Cut>& reference, const std::vector<Cut>& made) {
    std::vector<Candidate> candidates;
    for (std::size_t r = 0; r < reference.size(); ++r) {
        for (std::size_t m = 0; m < made.size(); ++m) {
            const Cut &a = reference[r], &b = made[m];
            if ((a.center - b.center).norm() - a.radius - b.radius >= b.length) continue;
            const double distance =
                0.5 * (mean_distance(a.nodes, b.nodes) + mean_distance(b.nodes, a.nodes));
            if (distance < b.length) candidates.push_back({distance, r, m});
        }
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<bool> reference_paired(reference.size(), false), made_paired(made.size(), false);
    RegisteredCuts result;
    for (const Candidate& pair : candidates) {
        if (reference_paired[pair.reference] || made_paired[pair.made]) continue;
        reference_paired[pair.reference] = made_paired[pair.made] = true;
        ++result.pairs;
        result.distance += pair.distance;
    }
    for (std::size_t r = 0; r < reference.size(); ++r) {
        if (!reference_paired[r]) result.missing += reference[r].length;
    }
    for (std::size_t m = 0; m < made.size(); ++m) {
        if (!made_paired[m]) result.additional += made[m].length;
    }
    return result;
}

}  // namespace ossuary::decomposition
