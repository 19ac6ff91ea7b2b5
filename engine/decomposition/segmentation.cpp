#include "engine/decomposition/segmentation.h"

#include <unordered_map>

namespace ossuary::decomposition {

Segmentation dense_segmentation(const std::vector<std::uint32_t>& labels) {
    Segmentation dense;
    dense.labels.reserve(labels.size());
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    for (const std::uint32_t label : labels) {
        const auto next = static_cast<std::uint32_t>(numbers.size());
        dense.labels.push_back(numbers.try_emplace(label, next).first->second);
    }
    dense.parts = static_cast<std::uint32_t>(numbers.size());
    return dense;
}

}  // namespace ossuary::decomposition
