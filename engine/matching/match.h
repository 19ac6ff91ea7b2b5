#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ossuary::matching {

/// A named share of a distance, for explanations.
struct DistancePart {
    std::string name;  ///< snake_case
    double value = 0.0;
};

/// Which nodes and branches of two skeletons belong together, and what each pair costs. Indices are
/// those of the two refined SkeletonGraphs that the descriptors were made from (thesis sec. 3.3.1:
/// the matched nodes, their number, and the sizes of the clusters of matched nodes).
struct Correspondence {
    struct Pair {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        double cost = 0.0;
    };
    std::vector<Pair> nodes;
    std::vector<Pair> branches;
    std::vector<std::uint32_t> cluster_sizes;  ///< connected groups of matched nodes, largest first
};

/// The outcome of comparing two skeletons.
struct Match {
    double distance = 0.0;  ///< 0 for equal skeletons; symmetric; at most about 1
    std::vector<DistancePart> parts;
    Correspondence correspondence;
    /// How unlike the two are built, and how differently they stand: each over what is usual for
    /// two models, so that 0 is the same and 1 a pair at random. Set by rankers that know them.
    std::optional<double> build = std::nullopt;
    std::optional<double> pose = std::nullopt;
};

}  // namespace ossuary::matching
