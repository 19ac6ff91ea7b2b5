#include "index/catalogue.h"

#include <algorithm>
#include <numeric>

#include "index/catalogue_sieve.h"

namespace ossuary::index {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the digits that `text` starts with off it; without the zeros in front.
std::string_view take_number(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string_view number = text.substr(0, end);
    text.remove_prefix(end);
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    return number;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
    const std::string_view whole_a = a;
    const std::string_view whole_b = b;
    while (!a.empty() && !b.empty()) {
        if (is_digit(a.front()) && is_digit(b.front())) {
            const std::string_view number_a = take_number(a);
            const std::string_view number_b = take_number(b);
            if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
            if (number_a != number_b) return number_a < number_b;
            continue;
        }
        const auto one = static_cast<unsigned char>(lower(a.front()));
        const auto other = static_cast<unsigned char>(lower(b.front()));
        if (one != other) return one < other;
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    if (a.empty() != b.empty()) return a.empty();
    return whole_a < whole_b;
}

std::string file_kind(std::string_view path) {
    // What follows a `#` is a member of an archive, with an ending, or an object, without.
    const std::size_t inside = path.rfind('#');
    if (inside != std::string_view::npos) {
        if (std::string kind = file_kind(path.substr(inside + 1)); !kind.empty()) return kind;
        path = path.substr(0, inside);
    }
    const std::size_t slash = path.rfind('/');
    const std::size_t start = slash == std::string_view::npos ? 0 : slash + 1;
    const std::size_t dot = path.rfind('.');
    constexpr std::size_t kLongest = 8;
    if (dot == std::string_view::npos || dot <= start || path.size() - dot - 1 > kLongest)
        return {};
    std::string kind;
    for (const char c : path.substr(dot + 1)) kind += lower(c);
    return kind;
}

Result<std::vector<std::size_t>> list_models(const Snapshot& snapshot, Store& store,
                                             const CatalogueFilter& filter, CatalogueOrder order) {
    std::vector<std::size_t> positions;
    if (order == CatalogueOrder::kId && filter.name_contains.empty() && !filter.folder &&
        !filter.kind && !filter.branches && !filter.loops && !filter.extent && !filter.unit) {
        // Known without a look at names.
        if (filter.class_name) {
            const auto of_class = snapshot.of_class(*filter.class_name);
            return std::vector<std::size_t>(of_class.begin(), of_class.end());
        }
        positions.resize(snapshot.size());
        std::iota(positions.begin(), positions.end(), std::size_t{0});
        return positions;
    }
    const auto catalogue = snapshot.catalogue(store);
    if (!catalogue) return catalogue.error();
    const Catalogue& models = **catalogue;
    if (order == CatalogueOrder::kName) {
        positions = models.by_name();
    } else {
        positions.resize(models.size());
        std::iota(positions.begin(), positions.end(), std::size_t{0});
    }
    Loops loops;
    if (filter.loops) {
        auto loaded = snapshot.loops(store);
        if (!loaded) return loaded.error();
        loops = *std::move(loaded);
    }
    const Sieve sieve(snapshot, filter, std::move(loops));
    std::erase_if(positions, [&](std::size_t at) { return sieve.failed(models[at], at) != 0; });
    const auto sort_by = [&](auto before) {
        std::stable_sort(positions.begin(), positions.end(), [&](std::size_t a, std::size_t b) {
            return before(models[a], models[b]);
        });
    };
    switch (order) {
        case CatalogueOrder::kId:
        case CatalogueOrder::kName:
            break;
        case CatalogueOrder::kNewest:
            sort_by([](const auto& a, const auto& b) { return a.indexed_at > b.indexed_at; });
            break;
        case CatalogueOrder::kFaces:
            sort_by([](const auto& a, const auto& b) { return a.faces > b.faces; });
            break;
        case CatalogueOrder::kBranches:
            sort_by([](const auto& a, const auto& b) { return a.branches > b.branches; });
            break;
    }
    return positions;
}

}  // namespace ossuary::index
