#include "engine/decomposition/patch_paths.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>

#include "engine/core/shortest_ways.h"

namespace ossuary::decomposition {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();
/// Keeps the Laplacian regular; small against any conductance that matters.
constexpr double kLeak = 1e-4;
constexpr double kMaxResistance = 1e4;

struct Step {
    std::uint32_t to;
    float cost;
};

}  // namespace

PatchTable least_sums(const PatchGraph& graph, const LinkCost& cost) {
    const std::size_t count = graph.size();
    std::vector<std::uint32_t> first = {0};
    std::vector<Step> steps;
    for (std::size_t p = 0; p < count; ++p) {
        for (const PatchGraph::Link& link : graph.links[p]) {
            steps.push_back({link.to, static_cast<float>(cost(p, link))});
        }
        first.push_back(static_cast<std::uint32_t>(steps.size()));
    }
    PatchTable sums(count, kUnreached);
    ShortestWays<float> ways;
    for (std::uint32_t source = 0; source < count; ++source) {
        const std::span<float> row(sums.row(source), count);
        row[source] = 0.0F;
        ways.search(row, std::span(&source, 1), [&](std::uint32_t p, const auto& reach) {
            for (std::uint32_t s = first[p]; s < first[p + 1]; ++s) {
                reach(steps[s].to, row[p] + steps[s].cost);
            }
        });
    }
    return sums;
}

PatchTable least_barriers(const PatchGraph& graph, const LinkCost& cost) {
    const std::size_t count = graph.size();
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> links;
    std::vector<std::uint32_t> group(count);
    std::vector<std::vector<std::uint32_t>> members(count);
    for (std::uint32_t p = 0; p < count; ++p) {
        group[p] = p;
        members[p] = {p};
        for (const PatchGraph::Link& link : graph.links[p]) {
            if (p < link.to) links.emplace_back(cost(p, link), p, link.to);
        }
    }
    std::sort(links.begin(), links.end());
    PatchTable barriers(count);
    for (const auto& [barrier, p, q] : links) {
        std::uint32_t a = group[p], b = group[q];
        if (a == b) continue;
        if (members[a].size() < members[b].size()) std::swap(a, b);
        for (const std::uint32_t x : members[a]) {
            for (const std::uint32_t y : members[b])
                barriers.set(x, y, static_cast<float>(barrier));
        }
        for (const std::uint32_t y : members[b]) group[y] = a;
        members[a].insert(members[a].end(), members[b].begin(), members[b].end());
        members[b].clear();
    }
    return barriers;
}

Resistances resistances(const PatchGraph& graph, const LinkCost& conductance) {
    const auto count = static_cast<Eigen::Index>(graph.size());
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t p = 0; p < graph.size(); ++p) {
        const auto i = static_cast<Eigen::Index>(p);
        for (const PatchGraph::Link& link : graph.links[p]) {
            const auto j = static_cast<Eigen::Index>(link.to);
            const double half = 0.5 * conductance(p, link);  // each link is seen from both ends
            laplacian(i, j) -= half;
            laplacian(j, i) -= half;
            laplacian(i, i) += half;
            laplacian(j, j) += half;
        }
    }
    const Eigen::VectorXd own = laplacian.diagonal().cwiseMax(1e-3).cwiseInverse();
    laplacian.diagonal().array() += kLeak;
    const Eigen::MatrixXd inverse = laplacian.llt().solve(Eigen::MatrixXd::Identity(count, count));
    Resistances result{PatchTable(graph.size()), PatchTable(graph.size())};
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            const double whole = std::clamp(inverse(i, i) + inverse(j, j) - 2.0 * inverse(i, j),
                                            0.0, kMaxResistance);
            const auto p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
            result.whole.set(p, q, static_cast<float>(whole));
            result.far.set(p, q, static_cast<float>(std::max(0.0, whole - own(i) - own(j))));
        }
    }
    return result;
}

}  // namespace ossuary::decomposition
