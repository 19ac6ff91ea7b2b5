#include "engine/ranking/rerank.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "engine/core/parallel.h"

namespace ossuary::ranking {
namespace {

/// The query (node 0 … or one of the models, when it is in the collection) and the models nearest
/// to it, with all their mutual distances.
struct Neighborhood {
    std::size_t size = 0;
    std::size_t query = 0;
    std::vector<double> distances;  // size x size, bounded

    [[nodiscard]] double at(std::size_t i, std::size_t j) const { return distances[i * size + j]; }
};

/// [0, infinity) to [0, 1), in order.
double bounded_distance(double distance) {
    return std::isfinite(distance) ? distance / (1.0 + distance) : 1.0;
}

/// A sparse row of weights that sum to one, by ascending node.
using Encoding = std::vector<std::pair<std::size_t, double>>;

std::vector<std::size_t> head_of_list(const std::vector<double>& distances, std::size_t depth) {
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto nearer = [&](std::size_t a, std::size_t b) {
        return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
    };
    const std::size_t count = std::min(depth, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end(), nearer);
    order.resize(count);
    return order;
}

Neighborhood gather(const std::vector<std::size_t>& head, const std::vector<double>& distances,
                    const CollectionDistances& collection, int jobs) {
    // A query that is in the collection must not count twice in every neighbourhood.
    const bool inside = distances[head.front()] == 0.0;
    Neighborhood all;
    all.size = head.size() + (inside ? 0 : 1);
    all.query = inside ? 0 : head.size();
    all.distances.assign(all.size * all.size, 0.0);
    parallel_for(head.size(), jobs, [&](std::size_t i) {
        const auto others = std::span(head).subspan(i + 1);
        const std::vector<double> row = collection(head[i], others);
        for (std::size_t n = 0; n < others.size(); ++n) {
            const std::size_t j = i + 1 + n;
            const double d = bounded_distance(row[n]);
            all.distances[i * all.size + j] = d;
            all.distances[j * all.size + i] = d;
        }
    });
    for (std::size_t i = 0; i < head.size(); ++i) {
        const double d = bounded_distance(distances[head[i]]);
        all.distances[all.query * all.size + i] = d;
        all.distances[i * all.size + all.query] = d;
    }
    return all;
}

/// For each node the others from the nearest on, itself first.
std::vector<std::vector<std::size_t>> sorted_neighbors(const Neighborhood& all, std::size_t count) {
    std::vector<std::vector<std::size_t>> lists(all.size);
    std::vector<std::size_t> order(all.size);
    for (std::size_t i = 0; i < all.size; ++i) {
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto nearer = [&](std::size_t a, std::size_t b) {
            if ((a == i) != (b == i)) return a == i;
            return all.at(i, a) != all.at(i, b) ? all.at(i, a) < all.at(i, b) : a < b;
        };
        const std::size_t kept = std::min(count, all.size);
        std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept),
                          order.end(), nearer);
        lists[i].assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept));
    }
    return lists;
}

/// The nodes among the first `k` + 1 of i that have i among their own first `k` + 1; ascending.
std::vector<std::size_t> reciprocal(const std::vector<std::vector<std::size_t>>& lists,
                                    std::size_t i, std::size_t k) {
    const auto head_end = [&](const std::vector<std::size_t>& list) {
        return list.begin() + static_cast<std::ptrdiff_t>(std::min(k + 1, list.size()));
    };
    std::vector<std::size_t> result;
    for (auto j = lists[i].begin(); j != head_end(lists[i]); ++j) {
        const auto& back = lists[*j];
        if (std::find(back.begin(), head_end(back), i) != head_end(back)) result.push_back(*j);
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// The reciprocal neighbourhood of i, with those of its members that lie mostly inside it added.
std::vector<std::size_t> expanded(const std::vector<std::vector<std::size_t>>& lists,
                                  const std::vector<std::vector<std::size_t>>& half_reciprocal,
                                  std::size_t i, std::size_t k) {
    const std::vector<std::size_t> core = reciprocal(lists, i, k);
    std::vector<std::size_t> result = core;
    std::vector<std::size_t> common;
    for (const std::size_t member : core) {
        const auto& others = half_reciprocal[member];
        common.clear();
        std::set_intersection(core.begin(), core.end(), others.begin(), others.end(),
                              std::back_inserter(common));
        if (3 * common.size() >= 2 * others.size()) {
            result.insert(result.end(), others.begin(), others.end());
        }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<Encoding> encode(const Neighborhood& all, const RerankOptions& options) {
    const std::size_t k = options.neighbors;
    const auto lists = sorted_neighbors(all, std::max(k, options.expansion) + 1);
    std::vector<std::vector<std::size_t>> half(all.size);
    for (std::size_t i = 0; i < all.size; ++i) half[i] = reciprocal(lists, i, (k + 1) / 2);

    // Distances in units of the mean distance to the k-th neighbour.
    double unit = 0.0;
    for (std::size_t i = 0; i < all.size; ++i) {
        unit += all.at(i, lists[i][std::min(k, lists[i].size() - 1)]);
    }
    unit = std::max(unit / static_cast<double>(all.size), 1e-12);

    std::vector<Encoding> plain(all.size);
    for (std::size_t i = 0; i < all.size; ++i) {
        double total = 0.0;
        for (const std::size_t j : expanded(lists, half, i, k)) {
            plain[i].emplace_back(j, std::exp(-all.at(i, j) / unit));
            total += plain[i].back().second;
        }
        for (auto& [node, weight] : plain[i]) weight /= total;
    }

    std::vector<Encoding> averaged(all.size);
    std::vector<double> dense(all.size);
    for (std::size_t i = 0; i < all.size; ++i) {
        std::fill(dense.begin(), dense.end(), 0.0);
        const std::size_t count =
            std::min(std::max<std::size_t>(options.expansion, 1), lists[i].size());
        for (std::size_t n = 0; n < count; ++n) {
            for (const auto& [node, weight] : plain[lists[i][n]]) {
                dense[node] += weight / static_cast<double>(count);
            }
        }
        for (std::size_t node = 0; node < all.size; ++node) {
            if (dense[node] > 0.0) averaged[i].emplace_back(node, dense[node]);
        }
    }
    return averaged;
}

/// 1 - sum of minima / sum of maxima; both rows sum to one.
double jaccard_distance(const Encoding& a, const Encoding& b) {
    double common = 0.0;
    auto i = a.begin();
    auto j = b.begin();
    while (i != a.end() && j != b.end()) {
        if (i->first == j->first) {
            common += std::min(i->second, j->second);
            ++i, ++j;
        } else if (i->first < j->first) {
            ++i;
        } else {
            ++j;
        }
    }
    return std::max(0.0, 1.0 - common / (2.0 - common));
}

}  // namespace

std::vector<double> rerank(const std::vector<double>& distances,
                           const CollectionDistances& collection, const RerankOptions& options,
                           int jobs) {
    std::vector<double> result(distances.size());
    for (std::size_t j = 0; j < distances.size(); ++j)
        result[j] = 1.0 + bounded_distance(distances[j]);
    const std::vector<std::size_t> head = head_of_list(distances, options.depth);
    if (head.empty()) return result;
    const Neighborhood all = gather(head, distances, collection, jobs);
    const std::vector<Encoding> encodings = encode(all, options);
    for (std::size_t i = 0; i < head.size(); ++i) {
        const double original = bounded_distance(distances[head[i]]);
        const double overlap =
            i == all.query ? 0.0 : jaccard_distance(encodings[all.query], encodings[i]);
        result[head[i]] =
            (1.0 - options.original_weight) * overlap + options.original_weight * original;
    }
    return result;
}

}  // namespace ossuary::ranking
