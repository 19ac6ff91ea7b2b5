#include "engine/decomposition/small_parts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/mesh/edge_table.h"

namespace ossuary::decomposition {
namespace {

/// The part with the longest border to `part`, the least number of equals; none without a border.
std::optional<std::uint32_t> longest_neighbor(const SurfaceGraph& surface,
                                              const std::vector<std::uint32_t>& part_of_triangle,
                                              std::uint32_t part) {
    std::map<std::uint32_t, double> borders;
    for (std::size_t t = 0; t < surface.size(); ++t) {
        if (part_of_triangle[t] != part) continue;
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t other = surface.across[t][side];
            if (other == mesh::kNoTriangle || part_of_triangle[other] == part) continue;
            borders[part_of_triangle[other]] += static_cast<double>(surface.side_lengths[t][side]);
        }
    }
    const auto longest =
        std::max_element(borders.begin(), borders.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (longest == borders.end()) return std::nullopt;
    return longest->first;
}

}  // namespace

void join_small_parts(const SurfaceGraph& surface, std::vector<std::uint32_t>& part_of_triangle,
                      double share) {
    const double least = share * surface.total_area;
    std::map<std::uint32_t, double> areas;
    for (std::size_t t = 0; t < surface.size(); ++t) areas[part_of_triangle[t]] += surface.areas[t];
    while (!areas.empty()) {
        const auto smallest =
            std::min_element(areas.begin(), areas.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        const auto [part, area] = *smallest;
        if (area >= least) return;
        areas.erase(smallest);
        const auto neighbor = longest_neighbor(surface, part_of_triangle, part);
        if (!neighbor) continue;
        std::replace(part_of_triangle.begin(), part_of_triangle.end(), part, *neighbor);
        // Not where the neighbour is a loose piece's, which is settled.
        if (const auto joined = areas.find(*neighbor); joined != areas.end())
            joined->second += area;
    }
}

}  // namespace ossuary::decomposition
