#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace ossuary {

/// Dijkstra's search over any graph. Keeps its buffer between calls.
/// @tparam Key  what is made least: a length, or a tuple that begins with it
template <typename Key>
class ShortestWays {
public:
    /// Lowers `least` to the keys of the least ways from the sources, whose own keys stand there
    /// already.
    /// @param least  a key a node; elsewhere than at sources what no way reaches
    /// @param links  links(node, reach) calls reach(to, key) for each link of `node`; the key of
    ///               the way through it, never less than the node's own; reach answers whether that
    ///               is the least so far, for what else is kept of a way
    template <typename Links>
    void search(std::span<Key> least, std::span<const std::uint32_t> sources, const Links& links) {
        search(least, sources, links, [](std::uint32_t) {});
    }

    /// @param settled  called for each node that is reached, in the order of keys, then of numbers
    template <typename Links, typename Settled>
    void search(std::span<Key> least, std::span<const std::uint32_t> sources, const Links& links,
                const Settled& settled) {
        for (const std::uint32_t source : sources) queue_.push({least[source], source});
        const auto reach = [&](std::uint32_t to, const Key& key) {
            if (!(key < least[to])) return false;
            least[to] = key;
            queue_.push({key, to});
            return true;
        };
        while (!queue_.empty()) {
            const auto [key, node] = queue_.top();
            queue_.pop();
            if (least[node] < key) continue;
            settled(node);
            links(node, reach);
        }
    }

private:
    using Entry = std::pair<Key, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace ossuary
