#include "engine/voxel/count_components.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/disjoint_sets.h"

namespace ossuary::voxel {
namespace {

/// A stretch along x of a beam: of the four rows y, y + 1, z, z + 1 with even y and z. Voxels of a
/// beam with equal or neighbouring x are neighbours, so each stretch is connected.
struct Stretch {
    std::int32_t begin, end;
};

class Beams {
public:
    explicit Beams(const BitVolume& volume)
        : volume_(volume),
          ny_((volume.size().y() + 1) / 2),
          nz_((volume.size().z() + 1) / 2),
          empty_(volume.words_per_row(), 0) {
        std::vector<std::uint64_t> beam(volume.words_per_row());
        first_.reserve(static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_) + 1);
        for (int z = 0; z < nz_; ++z) {
            for (int y = 0; y < ny_; ++y) {
                first_.push_back(static_cast<std::uint32_t>(stretches_.size()));
                const std::array<const std::uint64_t*, 4> rows = {
                    row(2 * y, 2 * z), row(2 * y + 1, 2 * z), row(2 * y, 2 * z + 1),
                    row(2 * y + 1, 2 * z + 1)};
                std::uint64_t any = 0;
                for (std::size_t w = 0; w < beam.size(); ++w) {
                    beam[w] = rows[0][w] | rows[1][w] | rows[2][w] | rows[3][w];
                    any |= beam[w];
                }
                if (any == 0) continue;
                for_each_run(beam, volume.size().x(), false, [&](int begin, int end) {
                    stretches_.push_back({begin, end});
                });
            }
        }
        first_.push_back(static_cast<std::uint32_t>(stretches_.size()));
    }

    [[nodiscard]] std::size_t count_components() const {
        mesh::DisjointSets sets(stretches_.size());
        std::size_t components = stretches_.size();
        for (int z = 0; z < nz_; ++z) {
            for (int y = 0; y < ny_; ++y) {
                if (first_[beam(y, z)] == first_[beam(y, z) + 1]) continue;
                const int y0 = 2 * y, z0 = 2 * z;
                // Only rows of two beams that lie side by side have neighbours in each other.
                components -= unite(y, z, y - 1, z, {row(y0, z0), row(y0, z0 + 1)},
                                    {row(y0 - 1, z0), row(y0 - 1, z0 + 1)}, sets);
                components -= unite(y, z, y, z - 1, {row(y0, z0), row(y0 + 1, z0)},
                                    {row(y0, z0 - 1), row(y0 + 1, z0 - 1)}, sets);
                components -= unite(y, z, y - 1, z - 1, {row(y0, z0), empty_.data()},
                                    {row(y0 - 1, z0 - 1), empty_.data()}, sets);
                components -= unite(y, z, y + 1, z - 1, {row(y0 + 1, z0), empty_.data()},
                                    {row(y0 + 2, z0 - 1), empty_.data()}, sets);
            }
        }
        return components;
    }

private:
    using TwoRows = std::array<const std::uint64_t*, 2>;

    [[nodiscard]] const std::uint64_t* row(int y, int z) const {
        const bool inside = y >= 0 && z >= 0 && y < volume_.size().y() && z < volume_.size().z();
        return inside ? volume_.row(y, z).data() : empty_.data();
    }
    [[nodiscard]] std::size_t beam(int y, int z) const {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(ny_) +
               static_cast<std::size_t>(y);
    }

    /// Unites the stretches of two beams that have neighbouring voxels in the rows given; returns
    /// how many sets became one with another.
    std::size_t unite(int y, int z, int other_y, int other_z, const TwoRows& rows,
                      const TwoRows& other_rows, mesh::DisjointSets& sets) const {
        if (other_y < 0 || other_z < 0 || other_y >= ny_) return 0;
        std::uint32_t a = first_[beam(y, z)], b = first_[beam(other_y, other_z)];
        const std::uint32_t a_end = first_[beam(y, z) + 1];
        const std::uint32_t b_end = first_[beam(other_y, other_z) + 1];
        std::size_t united = 0;
        while (a < a_end && b < b_end) {
            const Stretch& s = stretches_[a];
            const Stretch& t = stretches_[b];
            if (s.begin <= t.end && t.begin <= s.end && sets.find(a) != sets.find(b) &&
                touch(rows, s, other_rows, t)) {
                sets.unite(a, b);
                ++united;
            }
            if (stretches_[a].end < stretches_[b].end) {
                ++a;
            } else {
                ++b;
            }
        }
        return united;
    }

    /// Whether a voxel of `rows` in s has a neighbour of `others` in t.
    [[nodiscard]] bool touch(const TwoRows& rows, const Stretch& s, const TwoRows& others,
                             const Stretch& t) const {
        const auto words = static_cast<std::ptrdiff_t>(empty_.size());
        const auto at = [words](const TwoRows& two, const Stretch& within, std::ptrdiff_t w) {
            const auto base = static_cast<std::int32_t>(w * 64);
            if (w < 0 || w >= words || base >= within.end || base + 64 <= within.begin) {
                return std::uint64_t{0};
            }
            std::uint64_t mask = ~std::uint64_t{0};
            if (base < within.begin) mask <<= within.begin - base;
            if (base + 64 > within.end) mask &= ~std::uint64_t{0} >> (base + 64 - within.end);
            return (two[0][w] | two[1][w]) & mask;
        };
        for (std::ptrdiff_t w = s.begin >> 6; w <= (s.end - 1) >> 6; ++w) {
            const std::uint64_t other = at(others, t, w);
            const std::uint64_t near = other | (other << 1) | (other >> 1) |
                                       (at(others, t, w - 1) >> 63) | (at(others, t, w + 1) << 63);
            if ((at(rows, s, w) & near) != 0) return true;
        }
        return false;
    }

    const BitVolume& volume_;
    int ny_, nz_;
    std::vector<std::uint64_t> empty_;
    std::vector<Stretch> stretches_;
    std::vector<std::uint32_t> first_;  ///< stretch of each beam, and one more, where they end
};

}  // namespace

std::size_t count_components(const BitVolume& volume) { return Beams(volume).count_components(); }

}  // namespace ossuary::voxel
