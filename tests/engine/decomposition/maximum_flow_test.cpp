#include "engine/decomposition/maximum_flow.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace ossuary::decomposition {
namespace {

struct Edge {
    std::uint32_t a, b;
    std::int64_t capacity;
};

/// The capacity of the edges between the sides.
std::int64_t cost(const std::vector<Edge>& edges, const std::vector<bool>& side) {
    std::int64_t sum = 0;
    for (const Edge& edge : edges) sum += side[edge.a] != side[edge.b] ? edge.capacity : 0;
    return sum;
}

TEST(MaximumFlow, CutsTheCheapestEdgeOfAChain) {
    MaximumFlow flow(4);
    flow.add_edge(0, 1, 5);
    flow.add_edge(1, 2, 2);
    flow.add_edge(2, 3, 4);
    EXPECT_EQ(flow.source_side(0, 3), (std::vector<bool>{true, true, false, false}));
}

TEST(MaximumFlow, FindsTheCheapestOfAllCutsOfSmallGraphs) {
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round) {
        const std::uint32_t nodes = 3 + static_cast<std::uint32_t>(random() % 6);
        std::vector<Edge> edges;
        for (std::uint32_t a = 0; a < nodes; ++a) {
            for (std::uint32_t b = 0; b < a; ++b) {
                if (random() % 2 == 0) edges.push_back({a, b, 1 + static_cast<int>(random() % 9)});
            }
        }
        MaximumFlow flow(nodes);
        for (const Edge& edge : edges) flow.add_edge(edge.a, edge.b, edge.capacity);
        const std::vector<bool> side = flow.source_side(0, 1);
        ASSERT_TRUE(side[0]);
        ASSERT_FALSE(side[1]);
        std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
        for (std::uint32_t cut = 0; cut < (1U << nodes); ++cut) {
            if ((cut & 3U) != 1U) continue;  // node 0 on the source's side, node 1 not
            std::vector<bool> other(nodes);
            for (std::uint32_t n = 0; n < nodes; ++n) other[n] = ((cut >> n) & 1U) != 0;
            cheapest = std::min(cheapest, cost(edges, other));
        }
        EXPECT_EQ(cost(edges, side), cheapest);
    }
}

}  // namespace
}  // namespace ossuary::decomposition
