#include "engine/chain_code/stretch_twist.h"

#include <utility>

namespace ossuary::chain_code {

double StretchTwist::distance() const {
    const std::size_t changes = twists + stretches;
    const std::size_t total = same + changes;
    return total == 0 ? 0.0 : static_cast<double>(changes) / static_cast<double>(total);
}

StretchTwist stretch_twist(std::string_view s, std::string_view p) {
    if (s.size() > p.size()) std::swap(s, p);
    StretchTwist result;
    std::size_t missing = p.size() - s.size();
    std::size_t at = 0;
    for (const char wanted : p) {
        if (at < s.size() && s[at] == wanted) {
            ++result.same;
            ++at;
        } else if (missing > 0) {
            ++result.stretches;
            --missing;
        } else {
            ++result.twists;
            ++at;
        }
    }
    return result;
}

}  // namespace ossuary::chain_code
