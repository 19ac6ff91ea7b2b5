#include "engine/decomposition/maximum_flow.h"

#include <algorithm>
#include <limits>

namespace ossuary::decomposition {

void MaximumFlow::add_edge(std::uint32_t a, std::uint32_t b, std::int64_t capacity) {
    if (a == b) return;
    links_[a].push_back({b, static_cast<std::uint32_t>(links_[b].size()), capacity});
    links_[b].push_back({a, static_cast<std::uint32_t>(links_[a].size() - 1), capacity});
}

bool MaximumFlow::spend(std::uint64_t steps) {
    steps_left_ -= std::min(steps, steps_left_);
    return steps_left_ > 0 && !stop_.stop_requested();
}

bool MaximumFlow::find_levels(std::uint32_t source, std::uint32_t sink) {
    level_.assign(links_.size(), -1);
    level_[source] = 0;
    queue_.assign(1, source);
    for (std::size_t next = 0; next < queue_.size(); ++next) {
        const std::uint32_t node = queue_[next];
        steps_left_ -= std::min<std::uint64_t>(links_[node].size(), steps_left_);
        for (const Arc& arc : links_[node]) {
            if (arc.residual <= 0 || level_[arc.to] >= 0) continue;
            level_[arc.to] = level_[node] + 1;
            queue_.push_back(arc.to);
        }
    }
    return level_[sink] >= 0;
}

/// Sends as much as fits along one way of ascending levels; 0 when there is none left. Walks
/// without recursion, since ways may be thousands of nodes long.
std::int64_t MaximumFlow::augment(std::uint32_t source, std::uint32_t sink) {
    std::vector<std::uint32_t>& way = queue_;
    way.assign(1, source);
    while (way.back() != sink) {
        steps_left_ -= std::min<std::uint64_t>(1, steps_left_);
        const std::uint32_t node = way.back();
        std::size_t& next = next_arc_[node];
        while (next < links_[node].size()) {
            const Arc& arc = links_[node][next];
            if (arc.residual > 0 && level_[arc.to] == level_[node] + 1) break;
            ++next;
        }
        if (next < links_[node].size()) {
            way.push_back(links_[node][next].to);
        } else {
            level_[node] = -1;  // leads nowhere
            way.pop_back();
            if (way.empty()) return 0;
            ++next_arc_[way.back()];
        }
    }
    std::int64_t flow = std::numeric_limits<std::int64_t>::max();
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        flow = std::min(flow, links_[way[k]][next_arc_[way[k]]].residual);
    }
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        Arc& arc = links_[way[k]][next_arc_[way[k]]];
        arc.residual -= flow;
        links_[arc.to][arc.reverse].residual += flow;
    }
    return flow;
}

std::vector<bool> MaximumFlow::source_side(std::uint32_t source, std::uint32_t sink) {
    while (find_levels(source, sink)) {
        next_arc_.assign(links_.size(), 0);
        while (augment(source, sink) > 0) {
            if (!spend(queue_.size())) return {};
        }
    }
    std::vector<bool> side(links_.size());
    for (std::size_t node = 0; node < side.size(); ++node) side[node] = level_[node] >= 0;
    return side;
}

}  // namespace ossuary::decomposition
