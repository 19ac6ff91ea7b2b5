#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace ossuary::matching {

/// Which of its three ways the cheapest edit of two trees goes, or that of what is below two nodes.
struct EditChoice {
    /// On within the second one's child, with all else of it inserted; on within the first one's
    /// child, with all else of it removed; or node for node.
    enum Kind : std::uint8_t { kInto, kOutOf, kAcross } kind = kAcross;
    std::uint32_t child = 0;  ///< of the second for kInto, of the first for kOutOf
};

/// Walks down the choices of a tree edit distance and collects the nodes that are exchanged.
/// @param trees  pairs of nodes whose trees are edited into each other
/// @param choice  choice(forest, i, j): of the trees at i and j, or of what is below these
/// @param children  children(i, j, pairs): appends how the children of i and j are paired
template <typename Choose, typename PairChildren>
void collect_exchanged(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& trees,
                       const Choose& choice, const PairChildren& children,
                       std::vector<std::pair<std::uint32_t, std::uint32_t>>& exchanged) {
    struct Task {
        bool forest;
        std::uint32_t i, j;
    };
    std::vector<Task> tasks;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> paired;
    for (const auto& [i, j] : trees) tasks.push_back({false, i, j});
    while (!tasks.empty()) {
        const auto [forest, i, j] = tasks.back();
        tasks.pop_back();
        const EditChoice chosen = choice(forest, i, j);
        if (chosen.kind == EditChoice::kInto) {
            tasks.push_back({forest, i, chosen.child});
        } else if (chosen.kind == EditChoice::kOutOf) {
            tasks.push_back({forest, chosen.child, j});
        } else if (!forest) {
            exchanged.emplace_back(i, j);
            tasks.push_back({true, i, j});
        } else {
            paired.clear();
            children(i, j, paired);
            for (const auto& [a, b] : paired) tasks.push_back({false, a, b});
        }
    }
}

}  // namespace ossuary::matching
