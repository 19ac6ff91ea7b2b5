#include "engine/voxel/ray_columns.h"

#include <algorithm>
#include <utility>

#include "engine/voxel/crossing_finder.h"

namespace ossuary::voxel {
namespace {

bool comes_before(const Crossing& a, const Crossing& b) {
    if (a.depth != b.depth) return a.depth < b.depth;
    if (a.part != b.part) return a.part < b.part;
    return a.entering > b.entering;
}

/// Sorts by line, then by depth; ties in an order of their own, so that nothing depends on the
/// order of the triangles. Crossings are counted into their lines first, which leaves a handful to
/// sort on each: for 130,000 crossings a fifth of the time of sorting row by row.
std::vector<Crossing> sorted_by_line(const std::vector<Crossing>& crossings) {
    if (crossings.empty()) return {};
    std::int32_t u0 = crossings[0].u, u1 = u0, v0 = crossings[0].v, v1 = v0;
    for (const Crossing& c : crossings) {
        u0 = std::min(u0, c.u);
        u1 = std::max(u1, c.u);
        v0 = std::min(v0, c.v);
        v1 = std::max(v1, c.v);
    }
    const auto width = static_cast<std::size_t>(u1 - u0 + 1);
    const auto line_of = [=](const Crossing& c) {
        return static_cast<std::size_t>(c.v - v0) * width + static_cast<std::size_t>(c.u - u0);
    };
    const std::size_t lines = width * static_cast<std::size_t>(v1 - v0 + 1);
    std::vector<std::uint32_t> next(lines + 1, 0);
    for (const Crossing& c : crossings) ++next[line_of(c) + 1];
    for (std::size_t i = 1; i <= lines; ++i) next[i] += next[i - 1];
    std::vector<Crossing> sorted(crossings.size());
    for (const Crossing& c : crossings) sorted[next[line_of(c)]++] = c;
    // By now next[i] is where line i ends.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < lines; ++i) {
        const std::size_t end = next[i];
        if (end - begin > 16) {
            std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
                      sorted.begin() + static_cast<std::ptrdiff_t>(end), comes_before);
        } else {
            for (std::size_t k = begin + 1; k < end; ++k) {
                for (std::size_t j = k; j > begin && comes_before(sorted[j], sorted[j - 1]); --j) {
                    std::swap(sorted[j], sorted[j - 1]);
                }
            }
        }
        begin = end;
    }
    return sorted;
}

}  // namespace

std::vector<Crossing> cast_lines(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> part_of,
                                 const LineDirection& direction, CastMeter& meter) {
    std::vector<Crossing> crossings;
    CrossingFinder(mesh, direction, meter)
        .find(triangles, [&](std::int32_t u, std::int32_t v, std::int32_t depth, std::uint32_t t,
                             bool entering) {
            crossings.push_back({u, v, depth, part_of[t] & 0x3fffffffu, entering ? 1u : 0u});
        });
    return sorted_by_line(crossings);
}

}  // namespace ossuary::voxel
