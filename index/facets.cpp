#include <algorithm>
#include <map>

#include "index/catalogue.h"
#include "index/catalogue_sieve.h"
#include "index/number_ranges.h"
#include "index/unit.h"

namespace ossuary::index {

namespace {

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

/// Counts ranges by their places.
template <typename Ranges>
class RangeCounts {
public:
    explicit RangeCounts(Ranges ranges) : ranges_(ranges), counts_(ranges.size(), 0) {}
    void add(std::size_t range) { ++counts_[range]; }
    [[nodiscard]] std::vector<FacetValue> values() const {
        std::vector<FacetValue> values;
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            if (counts_[i] > 0) values.push_back({std::string(ranges_[i]), counts_[i]});
        }
        return values;
    }

private:
    const Ranges ranges_;
    std::vector<std::size_t> counts_;
};

/// What models' numbers are counted by.
class NumberCounts {
public:
    template <typename CountsFor>
    void add(const CatalogueEntry& model, const CountsFor& counts_for) {
        if (counts_for(Asked::kBranches)) branches_.add(branch_range(model.branches));
        if (counts_for(Asked::kExtent)) {
            extents_.add(extent_range(model.longest_side, model.metres_per_unit));
        }
        if (counts_for(Asked::kUnit)) ++lengths_[model.metres_per_unit];
    }
    template <typename CountsFor>
    void add_loops(std::uint32_t loops, const CountsFor& counts_for) {
        if (counts_for(Asked::kLoops)) loops_.add(loop_range(loops));
    }
    void fill(Facets& facets) const {
        facets.branches = branches_.values();
        facets.loops = loops_.values();
        facets.extents = extents_.values();
        Counts units;
        for (const auto& [metres, models] : lengths_) units[unit_name(metres)] += models;
        facets.units = values_of(units);
    }

private:
    RangeCounts<decltype(kBranchRanges)> branches_{kBranchRanges};
    RangeCounts<decltype(kLoopRanges)> loops_{kLoopRanges};
    RangeCounts<std::span<const std::string>> extents_{extent_ranges()};
    std::map<double, std::size_t> lengths_;  ///< of units, metres
};

void count_folders(Counts& counts, const std::string& folder, std::size_t models) {
    for (std::size_t end = folder.find('/'); end != std::string::npos;
         end = folder.find('/', end + 1)) {
        counts[folder.substr(0, end)] += models;
    }
    if (!folder.empty()) counts[folder] += models;
}

}  // namespace

Result<Facets> count_facets(const Snapshot& snapshot, Store& store, const CatalogueFilter& filter,
                            bool with_loops) {
    const auto catalogue = snapshot.catalogue(store);
    if (!catalogue) return catalogue.error();
    Loops loops;
    if (with_loops || filter.loops) {
        auto loaded = snapshot.loops(store);
        if (!loaded) return loaded.error();
        loops = *std::move(loaded);
    }
    const Sieve sieve(snapshot, filter, loops);
    Counts classes, whole_folders, kinds;
    // Most models have the class, folder and ending of the one before.
    Run class_run(classes), folder_run(whole_folders), kind_run(kinds);
    NumberCounts numbers;
    for (std::size_t i = 0; i < (*catalogue)->size(); ++i) {
        const CatalogueEntry& model = (**catalogue)[i];
        const unsigned failed = sieve.failed(model, i);
        const auto counts_for = [failed](Asked question) {
            return (failed & ~static_cast<unsigned>(question)) == 0;
        };
        if (counts_for(Asked::kClass)) class_run.add(model.class_name);
        if (counts_for(Asked::kFolder)) {
            folder_run.add(folder_of(snapshot.roots().relative(model.path)));
        }
        if (counts_for(Asked::kKind)) kind_run.add(file_kind(model.path));
        numbers.add(model, counts_for);
        if (loops) numbers.add_loops((*loops)[i], counts_for);
    }
    class_run.end();
    kind_run.end();
    folder_run.end();
    kinds.erase("");
    Counts folders;
    for (const auto& [folder, models] : whole_folders) count_folders(folders, folder, models);
    Facets facets;
    facets.classes = values_of(classes);
    facets.folders = values_of(folders);
    facets.kinds = values_of(kinds);
    numbers.fill(facets);
    return facets;
}

}  // namespace ossuary::index
