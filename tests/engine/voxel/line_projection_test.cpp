#include "engine/voxel/line_projection.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "engine/voxel/crossing_finder.h"

namespace ossuary::voxel {
namespace {

/// A mesh of unrelated triangles of all sizes; some corners on lines, some edges along them.
GridMesh random_triangles(std::uint32_t seed) {
    GridMesh mesh;
    mesh.size = {64, 64, 64};
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::int32_t> anywhere(2 * kGridOne, 62 * kGridOne);
    for (std::uint32_t t = 0; t < 400; ++t) {
        const std::int32_t reach = kGridOne << (t % 6);
        std::uniform_int_distribution<std::int32_t> near(-reach / 2, reach / 2);
        const GridPoint middle = {anywhere(random), anywhere(random), anywhere(random)};
        for (int corner = 0; corner < 3; ++corner) {
            GridPoint p;
            for (std::size_t x = 0; x < 3; ++x) {
                p[x] = std::clamp(middle[x] + near(random), 2 * kGridOne, 62 * kGridOne);
                if (t % 3 == 0) p[x] = (p[x] >> kGridBits) * kGridOne + kGridHalf;
            }
            mesh.points.push_back(p);
        }
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
}

/// The depth at which a line meets a triangle's plane, in double precision throughout.
double depth_of(const LineCorners& p, double u, double v) {
    const auto side = [&](const LinePoint& a, const LinePoint& b) {
        return (a.u - u) * (b.v - v) - (a.v - v) * (b.u - u);
    };
    const double a = side(p.b, p.c), b = side(p.c, p.a), c = side(p.a, p.b);
    return (a * p.a.depth + b * p.b.depth + c * p.c.depth) / (a + b + c);
}

TEST(CrossingFinder, FindsWhatEachLineSaysOfEachTriangle) {
    std::size_t found = 0;
    for (std::size_t d = 0; d < kThirteenDirections.size(); ++d) {
        const GridMesh mesh = random_triangles(static_cast<std::uint32_t>(d));
        const LineDirection& direction = kThirteenDirections[d];
        const LineProjection project(direction);
        using Key = std::array<std::int32_t, 3>;  // triangle, u, v
        std::map<Key, std::pair<std::int32_t, bool>> expected, actual;
        std::vector<std::uint32_t> all;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            all.push_back(t);
            const auto& [i, j, k] = mesh.triangles[t];
            const LineCorners p = {project(mesh.points[i]), project(mesh.points[j]),
                                   project(mesh.points[k])};
            for (std::int32_t v = -64; v < 128; ++v) {
                for (std::int32_t u = -64; u < 128; ++u) {
                    const LinePlace place(p, project.lattice_u.position(u),
                                          project.lattice_v.position(v));
                    if (!place.crosses()) continue;
                    expected[{static_cast<std::int32_t>(t), u, v}] = {place.depth(p),
                                                                      place.enters()};
                    const double depth =
                        depth_of(p, project.lattice_u.position(u), project.lattice_v.position(v));
                    EXPECT_NEAR(place.depth(p), depth + 0.5, 0.6);
                }
            }
        }
        const std::stop_token never;
        CastMeter meter(Vec3i::Constant(128), never);
        CrossingFinder(mesh, direction, meter)
            .find(all, [&](std::int32_t u, std::int32_t v, std::int32_t depth, std::uint32_t t,
                           bool entering) {
                const bool added =
                    actual.try_emplace({static_cast<std::int32_t>(t), u, v}, depth, entering)
                        .second;
                EXPECT_TRUE(added);
            });
        EXPECT_EQ(actual, expected);
        found += actual.size();
    }
    EXPECT_GT(found, 50000u);
}

TEST(RunningQuotient, IsTheFloorOfTheSum) {
    std::mt19937_64 random(7);
    std::uniform_int_distribution<std::int64_t> number(-1'000'000'000'000, 1'000'000'000'000);
    for (int i = 0; i < 300; ++i) {
        const std::int64_t start = number(random), growth = number(random) >> (i % 30);
        const std::int64_t divisor = 1 + std::abs(number(random) >> (i % 37));
        RunningQuotient quotient(start, growth, divisor);
        for (std::int64_t k = 0; k < 50; ++k) {
            const std::int64_t sum = start + k * growth;
            const std::int64_t floor = sum / divisor - (sum % divisor < 0 ? 1 : 0);
            ASSERT_EQ(quotient.floor(), floor) << start << " " << growth << " " << divisor;
            quotient.grow();
        }
    }
}

}  // namespace
}  // namespace ossuary::voxel
