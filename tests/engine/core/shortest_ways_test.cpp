#include "engine/core/shortest_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>

namespace ossuary {
namespace {

constexpr int kUnreached = std::numeric_limits<int>::max();

struct Link {
    std::uint32_t to;
    int length;
};
using Graph = std::vector<std::vector<Link>>;

Graph random_graph(unsigned seed) {
    std::mt19937 random(seed);
    Graph graph(1 + random() % 30);
    const std::size_t links = random() % (3 * graph.size());
    for (std::size_t i = 0; i < links; ++i) {
        graph[random() % graph.size()].push_back(
            {static_cast<std::uint32_t>(random() % graph.size()), static_cast<int>(random() % 6)});
    }
    return graph;
}

/// Relaxes every link until nothing changes.
std::vector<int> by_relaxation(const Graph& graph, std::vector<int> least) {
    for (std::size_t round = 0; round < graph.size(); ++round) {
        for (std::size_t node = 0; node < graph.size(); ++node) {
            if (least[node] == kUnreached) continue;
            for (const Link& link : graph[node]) {
                least[link.to] = std::min(least[link.to], least[node] + link.length);
            }
        }
    }
    return least;
}

TEST(ShortestWays, AreThoseOfRelaxingEveryLink) {
    ShortestWays<int> ways;
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Graph graph = random_graph(seed);
        std::vector<int> least(graph.size(), kUnreached);
        const std::vector<std::uint32_t> sources = {0,
                                                    static_cast<std::uint32_t>(graph.size() - 1)};
        least[sources[0]] = 0;
        least[sources[1]] = std::min(least[sources[1]], 2);
        const std::vector<int> expected = by_relaxation(graph, least);
        std::vector<std::uint32_t> order;
        ways.search(
            std::span<int>(least), sources,
            [&](std::uint32_t node, const auto& reach) {
                for (const Link& link : graph[node]) reach(link.to, least[node] + link.length);
            },
            [&](std::uint32_t node) { order.push_back(node); });
        EXPECT_EQ(least, expected) << "seed " << seed;
        EXPECT_TRUE(std::ranges::is_sorted(order, {}, [&](std::uint32_t n) { return least[n]; }));
    }
}

TEST(ShortestWays, SayWhichLinkIsTheLeastSoFar) {
    // 0 to 1 directly takes 5, over 2 it takes 3.
    const Graph graph = {{{1, 5}, {2, 1}}, {}, {{1, 2}}};
    std::vector<int> least = {0, kUnreached, kUnreached};
    std::vector<std::uint32_t> from(3, 99);
    const std::uint32_t source = 0;
    ShortestWays<int>().search(std::span<int>(least), std::span(&source, 1),
                               [&](std::uint32_t node, const auto& reach) {
                                   for (const Link& link : graph[node]) {
                                       if (reach(link.to, least[node] + link.length)) {
                                           from[link.to] = node;
                                       }
                                   }
                               });
    EXPECT_EQ(least, (std::vector<int>{0, 3, 1}));
    EXPECT_EQ(from, (std::vector<std::uint32_t>{99, 2, 0}));
}

}  // namespace
}  // namespace ossuary
