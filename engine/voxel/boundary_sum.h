#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ossuary::voxel {

/// A pseudo-random number for each of `count` points; the number of an edge is the product of its
/// points'.
inline std::vector<std::uint64_t> point_keys(std::size_t count) {
    std::vector<std::uint64_t> keys(count);
    std::uint64_t state = 0;
    for (std::uint64_t& key : keys) {
        state += 0x9E3779B97F4A7C15u;
        std::uint64_t x = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        key = x ^ (x >> 31);
    }
    return keys;
}

/// The boundary of a set of triangles as a sum of the numbers of their edges: 0 when every edge is
/// run along as often one way as the other (`oriented`) or an even number of times (`parity`), and
/// otherwise not 0 but for a chance of about one in 2^57 (a quadratic form in random numbers
/// vanishes no more often). Takes a tenth of the time of matching edges.
struct BoundarySum {
    std::uint64_t oriented = 0;
    std::uint64_t parity = 0;

    /// Returns a number of the triangle that does not depend on the order of its corners.
    std::uint64_t add(const std::array<std::uint32_t, 3>& t,
                      const std::vector<std::uint64_t>& keys) {
        const std::array<std::uint64_t, 3> key = {keys[t[0]], keys[t[1]], keys[t[2]]};
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = i == 2 ? 0 : i + 1;
            const std::uint64_t edge = key[i] * key[k];
            const std::uint64_t backward = t[i] > t[k] ? ~std::uint64_t{0} : 0;
            oriented += (edge ^ backward) - backward;
            parity ^= edge;
            sum += edge;
        }
        return sum;
    }
};

}  // namespace ossuary::voxel
