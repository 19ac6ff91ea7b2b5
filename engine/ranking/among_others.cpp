#include "engine/ranking/among_others.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace ossuary::ranking {

AmongOthers among_others(const DistanceMatrix& distances, std::span<const std::string> labels,
                         std::span<const std::string> others) {
    assert(labels.size() == distances.size && others.size() == distances.size);
    AmongOthers result;
    std::vector<std::size_t> order;
    for (std::size_t query = 0; query < labels.size(); ++query) {
        if (labels[query].empty()) continue;
        order.clear();
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const bool left_out = !others[i].empty() && others[i] == others[query];
            if (i != query && !left_out) order.push_back(i);
        }
        const auto key = [&](std::size_t i) {
            const float distance = distances.at(query, i);
            return std::isnan(distance) ? std::numeric_limits<float>::infinity() : distance;
        };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
        const auto right = [&](std::size_t i) { return labels[i] == labels[query]; };
        const std::ptrdiff_t wanted = std::count_if(order.begin(), order.end(), right);
        if (wanted == 0) continue;
        ++result.queries;
        if (right(order.front())) result.nearest_neighbor += 1.0;
        const std::ptrdiff_t found = std::count_if(order.begin(), order.begin() + wanted, right);
        result.first_tier += static_cast<double>(found) / static_cast<double>(wanted);
    }
    if (result.queries > 0) {
        result.nearest_neighbor /= static_cast<double>(result.queries);
        result.first_tier /= static_cast<double>(result.queries);
    }
    return result;
}

}  // namespace ossuary::ranking
