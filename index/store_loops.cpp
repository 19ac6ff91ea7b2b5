// How many loops skeletons have: read of their branches, without decoding a skeleton.

#include <algorithm>

#include "engine/mesh/disjoint_sets.h"
#include "index/store_impl.h"

namespace ossuary::index {

namespace {

/// The nodes of a skeleton, and how many loops its branches close.
class LoopCount {
public:
    explicit LoopCount(std::size_t nodes) : sets_(nodes), nodes_(nodes) {}

    /// A branch between what hangs together already closes a loop.
    void join(std::int64_t a, std::int64_t b) {
        const auto size = static_cast<std::int64_t>(nodes_);
        if (a < 0 || b < 0 || a >= size || b >= size) return;  // damaged: told by verify
        const std::uint32_t one = sets_.find(static_cast<std::uint32_t>(a));
        const std::uint32_t other = sets_.find(static_cast<std::uint32_t>(b));
        if (one == other) ++loops_;
        sets_.unite(one, other);
    }
    [[nodiscard]] std::uint32_t loops() const { return loops_; }

private:
    mesh::DisjointSets sets_;
    std::size_t nodes_;
    std::uint32_t loops_ = 0;
};

}  // namespace

Result<std::vector<ModelLoops>> Store::loops(ModelId first, ModelId last) {
    return impl_->locked([&]() -> Result<std::vector<ModelLoops>> {
        SQLite::Transaction transaction(impl_->database());
        std::vector<ModelLoops> models;
        Query nodes(
            impl_->statement("SELECT id, nodes FROM models WHERE id BETWEEN ? AND ? ORDER BY id"));
        Query branches(impl_->statement(
            "SELECT model, node_a, node_b FROM branches WHERE model BETWEEN ? AND ? "
            "ORDER BY model, branch"));
        nodes.bind(first, last);
        branches.bind(first, last);
        // No skeleton has more: a number that damage made must not fill memory.
        constexpr std::int64_t kMostNodes = 1 << 20;
        bool more = branches.step();
        while (nodes.step()) {
            const ModelId id = nodes.integer(0);
            LoopCount count(static_cast<std::size_t>(
                std::clamp<std::int64_t>(nodes.integer(1), 0, kMostNodes)));
            for (; more && branches.integer(0) <= id; more = branches.step()) {
                if (branches.integer(0) == id) count.join(branches.integer(1), branches.integer(2));
            }
            models.push_back({id, count.loops()});
        }
        return models;
    });
}

}  // namespace ossuary::index
