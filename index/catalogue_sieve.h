#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "index/catalogue.h"
#include "index/model_roots.h"

// Private to the catalogue's lists and counts.

namespace ossuary::index {

/// The questions of a CatalogueFilter.
enum class Asked {
    kName = 1,
    kClass = 2,
    kFolder = 4,
    kKind = 8,
    kBranches = 16,
    kLoops = 32,
    kExtent = 64,
    kUnit = 128,
};

/// How many loops each model has, by position; null where nobody asks.
using Loops = std::shared_ptr<const std::vector<std::uint32_t>>;

/// A filter with what it costs to ask it of many models.
class Sieve {
public:
    /// @pre `loops` is there if the filter asks for them
    Sieve(const Snapshot& snapshot, const CatalogueFilter& filter, Loops loops);

    /// Which of the filter's questions the model at a position fails, as a set of Asked.
    [[nodiscard]] unsigned failed(const CatalogueEntry& model, std::size_t position) const;

private:
    const ModelRoots& roots_;
    const CatalogueFilter& filter_;
    std::string name_;  ///< in small letters
    const std::optional<std::size_t> branches_, loop_range_, extent_;
    const Loops loops_;
};

/// As a small letter, where it is an ASCII one.
[[nodiscard]] constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// The folder of a path below the roots; empty for what lies in a root itself.
[[nodiscard]] std::string folder_of(const std::string& relative);

}  // namespace ossuary::index
