#include "index/catalogue.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace ossuary::index {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

/// Takes the digits that `text` starts with off it; without the zeros in front.
std::string_view take_number(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string_view number = text.substr(0, end);
    text.remove_prefix(end);
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    return number;
}

bool contains(std::string_view text, std::string_view lower_part) {
    return std::search(text.begin(), text.end(), lower_part.begin(), lower_part.end(),
                       [](char a, char b) { return lower(a) == b; }) != text.end();
}

/// Below the roots; empty for what lies in a root itself.
std::string folder_of(const std::string& relative) {
    const std::size_t inside = std::min(relative.find('#'), relative.size());
    const std::size_t slash = relative.rfind('/', inside);
    return slash == std::string::npos ? std::string() : relative.substr(0, slash);
}

bool is_in(const std::string& folder, const std::string& wanted) {
    return wanted.empty() || folder == wanted ||
           (folder.starts_with(wanted) && folder[wanted.size()] == '/');
}

enum class Asked { kName = 1, kClass = 2, kFolder = 4, kKind = 8 };

/// The filter with what it costs to ask it of many models.
class Sieve {
public:
    Sieve(const Snapshot& snapshot, const CatalogueFilter& filter)
        : roots_(snapshot.roots()), filter_(filter) {
        for (const char c : filter.name_contains) name_ += lower(c);
    }

    /// Which of the filter's questions a model fails, as a set of Asked.
    [[nodiscard]] unsigned failed(const CatalogueEntry& model) const {
        unsigned set = 0;
        const auto fail = [&set](Asked question) { set |= static_cast<unsigned>(question); };
        if (!name_.empty() && !contains(model.name, name_)) fail(Asked::kName);
        if (filter_.class_name && *filter_.class_name != model.class_name) fail(Asked::kClass);
        if (filter_.folder && !is_in(folder_of(roots_.relative(model.path)), *filter_.folder)) {
            fail(Asked::kFolder);
        }
        if (filter_.kind && *filter_.kind != file_kind(model.path)) fail(Asked::kKind);
        return set;
    }

private:
    const ModelRoots& roots_;
    const CatalogueFilter& filter_;
    std::string name_;  ///< in small letters
};

using Counts = std::map<std::string, std::size_t>;

std::vector<FacetValue> values_of(const Counts& counts) {
    std::vector<FacetValue> values;
    for (const auto& [value, models] : counts) values.push_back({value, models});
    if (values.size() > kMostFacetValues) {
        std::stable_sort(
            values.begin(), values.end(),
            [](const FacetValue& a, const FacetValue& b) { return a.models > b.models; });
        values.resize(kMostFacetValues);
    }
    std::stable_sort(values.begin(), values.end(), [](const FacetValue& a, const FacetValue& b) {
        return natural_less(a.value, b.value);
    });
    return values;
}

/// Counts values of which many equal the one before.
class Run {
public:
    explicit Run(Counts& counts) : counts_(counts) {}
    void add(std::string_view value) {
        if (length_ == 0 || value != value_) {
            end();
            value_ = value;
        }
        ++length_;
    }
    void end() {
        if (length_ > 0) counts_[value_] += length_;
        length_ = 0;
    }

private:
    Counts& counts_;
    std::string value_;
    std::size_t length_ = 0;
};

void count_folders(Counts& counts, const std::string& folder, std::size_t models) {
    for (std::size_t end = folder.find('/'); end != std::string::npos;
         end = folder.find('/', end + 1)) {
        counts[folder.substr(0, end)] += models;
    }
    if (!folder.empty()) counts[folder] += models;
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
        !filter.kind) {
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
    const Sieve sieve(snapshot, filter);
    std::erase_if(positions, [&](std::size_t at) { return sieve.failed(models[at]) != 0; });
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

Result<Facets> count_facets(const Snapshot& snapshot, Store& store, const CatalogueFilter& filter) {
    const auto catalogue = snapshot.catalogue(store);
    if (!catalogue) return catalogue.error();
    const Sieve sieve(snapshot, filter);
    Counts classes, folders, kinds;
    // Most models have the class, folder and ending of the one before.
    Run class_run(classes), kind_run(kinds);
    std::map<std::string, std::size_t> whole_folders;
    Run folder_run(whole_folders);
    for (std::size_t i = 0; i < (*catalogue)->size(); ++i) {
        const CatalogueEntry& model = (**catalogue)[i];
        const unsigned failed = sieve.failed(model);
        const auto counts_for = [failed](Asked question) {
            return (failed & ~static_cast<unsigned>(question)) == 0;
        };
        if (counts_for(Asked::kClass)) class_run.add(model.class_name);
        if (counts_for(Asked::kFolder)) {
            folder_run.add(folder_of(snapshot.roots().relative(model.path)));
        }
        if (counts_for(Asked::kKind)) kind_run.add(file_kind(model.path));
    }
    class_run.end();
    kind_run.end();
    folder_run.end();
    kinds.erase("");
    for (const auto& [folder, models] : whole_folders) count_folders(folders, folder, models);
    return Facets{values_of(classes), values_of(folders), values_of(kinds)};
}

}  // namespace ossuary::index
