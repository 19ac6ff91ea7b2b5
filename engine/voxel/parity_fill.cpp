#include "engine/voxel/parity_fill.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/voxel/crossing_finder.h"

namespace ossuary::voxel {
namespace {

/// Where the line (u, v) crosses a triangle, between two voxel centres.
struct Flip {
    std::uint16_t u, v;
    std::uint16_t gap;  ///< the first centre after it
    bool entering;
    std::uint32_t triangle;

    [[nodiscard]] std::size_t word() const { return gap >> 6; }
    [[nodiscard]] std::uint64_t bit() const { return std::uint64_t{1} << (gap & 63); }
};

/// All crossings, plane by plane of equal v: what a plane's lines need stays in the nearest cache.
struct FlipsByPlane {
    std::vector<Flip> flips;
    std::vector<std::size_t> begin;  ///< of each plane, and where the last one ends

    [[nodiscard]] std::span<const Flip> plane(std::size_t v) const {
        return std::span(flips).subspan(begin[v], begin[v + 1] - begin[v]);
    }
};

FlipsByPlane find_flips(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
                        const LineDirection& direction, CastMeter& meter) {
    const auto planes = static_cast<std::size_t>(mesh.size[(direction.axis + 2) % 3]);
    FlipsByPlane result;
    result.begin.assign(planes + 2, 0);  // for a while, begin[v + 2] is where plane v goes on
    std::vector<Flip> flips;
    flips.reserve(triangles.size());
    CrossingFinder(mesh, direction, meter)
        .find(triangles, [&](std::int32_t u, std::int32_t v, std::int32_t depth, std::uint32_t t,
                             bool entering) {
            flips.push_back({static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v),
                             static_cast<std::uint16_t>(first_centre_from(depth)), entering, t});
            ++result.begin[static_cast<std::size_t>(v) + 2];
        });
    for (std::size_t v = 2; v < result.begin.size(); ++v) result.begin[v] += result.begin[v - 1];
    result.flips.resize(flips.size());
    for (const Flip& flip : flips) {
        result.flips[result.begin[static_cast<std::size_t>(flip.v) + 1]++] = flip;
    }
    result.begin.pop_back();
    return result;
}

/// Collects marked lines of one plane after the other, and the triangles that they cross.
class Marks {
public:
    Marks(const GridMesh& mesh, int axis)
        : marked_(static_cast<std::size_t>(mesh.size[(axis + 1) % 3]), 0) {
        past_.lines = BitVolume({mesh.size[(axis + 1) % 3], mesh.size[(axis + 2) % 3], 1});
    }
    void mark(std::size_t u, bool marked = true) {
        marked_[u] |= static_cast<std::uint8_t>(marked);
    }
    [[nodiscard]] bool is_marked(std::size_t u) const { return marked_[u] != 0; }
    void end_plane(std::span<const Flip> flips) {
        for (const Flip& flip : flips) {
            if (!is_marked(flip.u)) continue;
            past_.lines.set(flip.u, flip.v, 0);
            past_.triangles.push_back(flip.triangle);
        }
        std::fill(marked_.begin(), marked_.end(), 0);
    }
    [[nodiscard]] LineSubset take() {
        auto& triangles = past_.triangles;
        std::sort(triangles.begin(), triangles.end());
        triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
        return std::move(past_);
    }

private:
    std::vector<std::uint8_t> marked_;
    LineSubset past_;
};

/// Bit i of the result is the sum modulo two of the bits up to i.
std::uint64_t running_parity(std::uint64_t word) {
    for (int shift = 1; shift < 64; shift *= 2) word ^= word << shift;
    return word;
}

/// Turns flips into insides, in place. Returns whether they enter and leave by turns.
bool sum_row(std::span<std::uint64_t> row, std::span<const std::uint64_t> entering) {
    std::uint64_t inside_before = 0;  // all ones after an odd number of flips
    std::uint64_t not_outward = 0, not_inward = 0;
    for (std::size_t w = 0; w < row.size(); ++w) {
        const std::uint64_t flipped = row[w];
        if (flipped == 0) {
            row[w] = inside_before;
            continue;
        }
        const std::uint64_t inside = running_parity(flipped) ^ inside_before;
        not_outward |= (inside ^ entering[w]) & flipped;
        not_inward |= ~(inside ^ entering[w]) & flipped;
        inside_before = std::uint64_t{0} - (inside >> 63);
        row[w] = inside;
    }
    return not_outward == 0 || not_inward == 0;
}

/// Marks lines that cross more than one part.
void mark_shared_lines(std::span<const Flip> flips, const SurfaceParts& parts,
                       std::vector<std::uint32_t>& part_of_line, Marks& marks) {
    constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();
    std::fill(part_of_line.begin(), part_of_line.end(), kNoPart);
    for (const Flip& flip : flips) {
        const std::uint32_t part = parts.part_of[flip.triangle];
        std::uint32_t& known = part_of_line[flip.u];
        marks.mark(flip.u, known != part && known != kNoPart);
        known = part;
    }
}

}  // namespace

LineSubset fill_by_parity(const GridMesh& mesh, std::span<const std::uint32_t> closed,
                          const SurfaceParts& parts, CastMeter& meter, BitVolume& volume) {
    const FlipsByPlane flips = find_flips(mesh, closed, kAxisDirections[0], meter);
    const std::size_t words = volume.words_per_row();
    const auto lines = static_cast<std::size_t>(mesh.size.y());
    std::vector<std::uint64_t> entering(words * lines, 0);
    std::vector<std::uint32_t> part_of_line(parts.count() > 1 ? lines : 0);
    Marks marks(mesh, 0);
    for (int v = mesh.low.z(); v < mesh.high.z(); ++v) {
        const auto plane = flips.plane(static_cast<std::size_t>(v));
        if (plane.empty()) continue;
        const auto rows =
            volume.words().subspan(words * lines * static_cast<std::size_t>(v), words * lines);
        std::fill(entering.begin(), entering.end(), 0);
        std::size_t first = lines, last = 0;
        for (const Flip& flip : plane) {
            const std::size_t w = words * flip.u + flip.word();
            marks.mark(flip.u, (rows[w] & flip.bit()) != 0);
            rows[w] ^= flip.bit();
            entering[w] |= flip.entering ? flip.bit() : 0;
            first = std::min<std::size_t>(first, flip.u);
            last = std::max<std::size_t>(last, flip.u);
        }
        if (parts.count() > 1) mark_shared_lines(plane, parts, part_of_line, marks);
        for (std::size_t u = first; u <= last; ++u) {
            const auto row = rows.subspan(words * u, words);
            const auto ways = std::span<const std::uint64_t>(entering).subspan(words * u, words);
            if (!sum_row(row, ways)) marks.mark(u);
            if (marks.is_marked(u)) std::fill(row.begin(), row.end(), 0);
        }
        marks.end_plane(plane);
    }
    return marks.take();
}

LineSubset find_shared_gaps(const GridMesh& mesh, const LineSubset& past, int axis,
                            CastMeter& meter) {
    Marks marks(mesh, axis);
    if (past.triangles.empty()) return marks.take();
    LineDirection direction = kAxisDirections[static_cast<std::size_t>(axis)];
    direction.only = &past.lines;
    const FlipsByPlane flips = find_flips(mesh, past.triangles, direction, meter);
    const auto lines = static_cast<std::size_t>(mesh.size[(axis + 1) % 3]);
    const std::size_t words = (static_cast<std::size_t>(mesh.size[axis]) + 63) / 64;
    std::vector<std::uint64_t> crossed(words * lines);
    for (std::size_t v = 0; v + 1 < flips.begin.size(); ++v) {
        const auto plane = flips.plane(v);
        if (plane.empty()) continue;
        std::fill(crossed.begin(), crossed.end(), 0);
        for (const Flip& flip : plane) {
            std::uint64_t& word = crossed[words * flip.u + flip.word()];
            marks.mark(flip.u, (word & flip.bit()) != 0);
            word |= flip.bit();
        }
        marks.end_plane(plane);
    }
    return marks.take();
}

}  // namespace ossuary::voxel
