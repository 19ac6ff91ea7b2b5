#include "engine/decomposition/prevailing_labels.h"

#include <cassert>
#include <map>

namespace ossuary::decomposition {

std::vector<std::int32_t> prevailing_labels(std::size_t groups,
                                            std::span<const std::uint32_t> group_of,
                                            std::span<const std::int32_t> label_of,
                                            std::span<const double> area) {
    assert(label_of.size() == group_of.size() && area.size() == group_of.size());
    std::vector<std::map<std::int32_t, double>> area_of_label(groups);
    for (std::size_t t = 0; t < group_of.size(); ++t) {
        if (label_of[t] >= 0) area_of_label[group_of[t]][label_of[t]] += area[t];
    }
    std::vector<std::int32_t> labels(groups, -1);
    for (std::size_t group = 0; group < groups; ++group) {
        double largest = -1.0;  // so that a label without any area is better than none
        for (const auto& [label, size] : area_of_label[group]) {
            if (size <= largest) continue;
            largest = size;
            labels[group] = label;
        }
    }
    return labels;
}

}  // namespace ossuary::decomposition
