#include "index/descriptor_cache.h"

#include <algorithm>

namespace ossuary::index {

namespace {

constexpr std::size_t kAlwaysKept = 2048;

template <typename T>
std::size_t bytes_in(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}

/// About what a descriptor takes in memory.
std::size_t bytes_of(const descriptor::ModelDescriptor& model) {
    constexpr std::size_t kOfNode = 64;  // of the trees, with their share of small vectors
    std::size_t bytes = sizeof model + bytes_in(model.signature);
    for (const auto& global : model.globals) bytes += sizeof global + bytes_in(global.values);
    const matching::SkeletonDescriptor& skeleton = model.skeleton;
    bytes += bytes_in(skeleton.nodes);
    for (const auto& branch : skeleton.branches) {
        bytes += sizeof branch + branch.chain_code.capacity() + bytes_in(branch.points) +
                 bytes_in(branch.radii);
    }
    // A batch lays the steps out a second time.
    bytes += 3 * bytes_in(skeleton.rooted.steps) + bytes_in(skeleton.rooted.pieces);
    for (const auto& tree : skeleton.rooted.trees) bytes += kOfNode * tree.nodes.size();
    return bytes + kOfNode * (skeleton.rooted.merged.nodes.size() + skeleton.nodes.size());
}

}  // namespace

std::vector<ranking::SharedDescriptor> DescriptorCache::find(const std::vector<Key>& keys) {
    std::vector<ranking::SharedDescriptor> found(keys.size());
    const Lock lock(mutex_);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto place = places_.find(keys[i]);
        if (place == places_.end()) continue;
        entries_.splice(entries_.begin(), entries_, place->second);
        found[i] = place->second->descriptor;
    }
    return found;
}

void DescriptorCache::keep(const Key& key, ranking::SharedDescriptor descriptor) {
    const std::size_t bytes = bytes_of(*descriptor);
    const Lock lock(mutex_);
    if (places_.contains(key)) return;
    entries_.push_front({key, std::move(descriptor), bytes});
    places_.emplace(key, entries_.begin());
    bytes_ += bytes;
    while (bytes_ > bytes_limit_ && entries_.size() > kAlwaysKept) {
        bytes_ -= entries_.back().bytes;
        places_.erase(entries_.back().key);
        entries_.pop_back();
    }
}

Result<std::vector<ranking::SharedDescriptor>> SnapshotDescriptors::fetch(
    std::span<const std::uint32_t> positions) {
    std::vector<DescriptorCache::Key> keys;
    keys.reserve(positions.size());
    for (const std::uint32_t position : positions) {
        keys.push_back({snapshot_.state().replacements, snapshot_.id(position),
                        snapshot_.changed_at(position)});
    }
    std::vector<ranking::SharedDescriptor> found(keys.size());
    if (cache_ != nullptr) found = cache_->find(keys);
    std::vector<ModelId> wanted;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (found[i]) continue;
        wanted.push_back(keys[i].id);
        places.push_back(i);
    }
    if (wanted.empty()) return found;
    const auto store = stores_.lend();
    if (!store) return store.error();
    auto read = (*store)->descriptors(wanted, jobs_);
    if (!read) return read.error();
    // Of another file that has taken the index's place the ids say nothing.
    const auto state = (*store)->collection_state();
    if (!state) return state.error();
    auto next = read->begin();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const DescriptorCache::Key& key = keys[places[i]];
        const bool there = next != read->end() && next->id == key.id;
        if (there && next->changed_at == key.changed_at &&
            state->replacements == key.replacements) {
            found[places[i]] =
                std::make_shared<const descriptor::ModelDescriptor>(std::move(next->descriptor));
            if (cache_ != nullptr) cache_->keep(key, found[places[i]]);
        } else {
            missed_ = true;
        }
        if (there) ++next;
    }
    return found;
}

}  // namespace ossuary::index
