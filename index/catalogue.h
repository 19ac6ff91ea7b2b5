#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "index/snapshot.h"

namespace ossuary::index {

/// Which models of a collection to list.
struct CatalogueFilter {
    std::optional<std::string> class_name = {};  ///< only this class; "" = those without one
    std::string name_contains = {};              ///< part of the name, any case (ASCII)
    std::optional<std::string> folder =
        {};  ///< below the roots; only what lies in it or further down
    std::optional<std::string> kind = {};  ///< only files of this ending, see file_kind
    // Only models whose number is in the range of that name (number_ranges.h); a name of no range
    // is passed by none.
    std::optional<std::string> branches = {};
    std::optional<std::string> loops = {};
    std::optional<std::string> extent = {};  ///< longest side
    std::optional<std::string> unit = {};    ///< only files in this unit, see unit_name
};

enum class CatalogueOrder {
    kId,
    kName,      ///< natural_less
    kNewest,    ///< indexed last first
    kFaces,     ///< most first
    kBranches,  ///< most first
};

/// The positions in the snapshot of the models that pass, in order; models that are equal in it in
/// the order of their ids. Errors: those of the store.
Result<std::vector<std::size_t>> list_models(const Snapshot& snapshot, Store& store,
                                             const CatalogueFilter& filter, CatalogueOrder order);

/// A value that models have, and how many.
struct FacetValue {
    std::string value;
    std::size_t models = 0;
    bool operator==(const FacetValue&) const = default;
};

/// What the models that pass a filter are like; each list as if the filter did not ask for just
/// that. In natural order; of more than kMostFacetValues values those of the most models.
struct Facets {
    std::vector<FacetValue> classes;  ///< "" = without a class
    std::vector<FacetValue> folders;  ///< below the roots; each counts what lies further down
    std::vector<FacetValue> kinds;
    std::vector<FacetValue> branches, loops, extents;  ///< ranges, ascending (number_ranges.h)
    std::vector<FacetValue> units;                     ///< "" = files that name none
};
inline constexpr std::size_t kMostFacetValues = 1000;
/// @param with_loops  whether to count loops too: the first time that takes several times as long
///                    as all else, since it reads of every skeleton (Snapshot::loops)
/// Errors: those of the store.
Result<Facets> count_facets(const Snapshot& snapshot, Store& store, const CatalogueFilter& filter,
                            bool with_loops = true);

/// The lower-case ending of the file (or member of an archive) that a path names, without dot:
/// `stl`; empty where there is none.
[[nodiscard]] std::string file_kind(std::string_view path);

/// By numbers where both have some, otherwise by bytes, ASCII letters as if small: a2 before A10.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

}  // namespace ossuary::index
