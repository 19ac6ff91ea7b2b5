#include "index/catalogue_sieve.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "index/number_ranges.h"
#include "index/unit.h"

namespace ossuary::index {

namespace {

bool contains(std::string_view text, std::string_view lower_part) {
    return std::search(text.begin(), text.end(), lower_part.begin(), lower_part.end(),
                       [](char a, char b) { return lower(a) == b; }) != text.end();
}

bool is_in(const std::string& folder, const std::string& wanted) {
    return wanted.empty() || folder == wanted ||
           (folder.starts_with(wanted) && folder[wanted.size()] == '/');
}

/// The place of the range that is asked for: past the end for a name of none.
template <typename Ranges>
std::optional<std::size_t> asked_range(const Ranges& ranges,
                                       const std::optional<std::string>& name) {
    if (!name) return std::nullopt;
    return find_range(ranges, *name).value_or(ranges.size());
}

}  // namespace

std::string folder_of(const std::string& relative) {
    const std::size_t inside = std::min(relative.find('#'), relative.size());
    const std::size_t slash = relative.rfind('/', inside);
    return slash == std::string::npos ? std::string() : relative.substr(0, slash);
}

Sieve::Sieve(const Snapshot& snapshot, const CatalogueFilter& filter, Loops loops)
    : roots_(snapshot.roots()),
      filter_(filter),
      branches_(asked_range(kBranchRanges, filter.branches)),
      loop_range_(asked_range(kLoopRanges, filter.loops)),
      extent_(asked_range(extent_ranges(), filter.extent)),
      loops_(std::move(loops)) {
    for (const char c : filter.name_contains) name_ += lower(c);
}

unsigned Sieve::failed(const CatalogueEntry& model, std::size_t position) const {
    unsigned set = 0;
    const auto fail = [&set](Asked question) { set |= static_cast<unsigned>(question); };
    if (!name_.empty() && !contains(model.name, name_)) fail(Asked::kName);
    if (filter_.class_name && *filter_.class_name != model.class_name) fail(Asked::kClass);
    if (filter_.folder && !is_in(folder_of(roots_.relative(model.path)), *filter_.folder)) {
        fail(Asked::kFolder);
    }
    if (filter_.kind && *filter_.kind != file_kind(model.path)) fail(Asked::kKind);
    if (branches_ && *branches_ != branch_range(model.branches)) fail(Asked::kBranches);
    if (loop_range_ && *loop_range_ != loop_range((*loops_)[position])) fail(Asked::kLoops);
    if (extent_ && *extent_ != extent_range(model.longest_side, model.metres_per_unit)) {
        fail(Asked::kExtent);
    }
    if (filter_.unit && *filter_.unit != unit_name(model.metres_per_unit)) fail(Asked::kUnit);
    return set;
}

}  // namespace ossuary::index
