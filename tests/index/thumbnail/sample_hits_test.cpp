#include "index/thumbnail/sample_hits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::index {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Soup {
    std::vector<Vec3f> vertices;
    std::vector<Triangle> triangles;
};

/// Triangles of all sizes that pass through each other, some of them partly outside the picture.
Soup soup_of(int count, int size) {
    std::mt19937_64 random(7);
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::uint32_t>(soup.vertices.size());
        soup.triangles.push_back({at, at + 1, at + 2});
        const double reach = i % 3 == 0 ? size : 3.0;
        const Vec3 middle(test::uniform(random, 0, size), test::uniform(random, 0, size), 0.0);
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 offset(test::uniform(random, -reach, reach),
                              test::uniform(random, -reach, reach),
                              test::uniform(random, -reach, reach));
            soup.vertices.push_back((middle + offset).cast<float>());
        }
    }
    return soup;
}

/// What lies nearest at a point, asked of every triangle.
double nearest_depth(const Soup& soup, double x, double y) {
    double nearest = -1e30;
    for (const auto& [i, j, k] : soup.triangles) {
        const Vec3 a = soup.vertices[i].cast<double>(), b = soup.vertices[j].cast<double>(),
                   c = soup.vertices[k].cast<double>();
        const Vec3 u = b - a, v = c - a;
        const double area = u.x() * v.y() - u.y() * v.x();
        if (area == 0.0) continue;
        const double s = ((x - a.x()) * v.y() - (y - a.y()) * v.x()) / area;
        const double t = (u.x() * (y - a.y()) - u.y() * (x - a.x())) / area;
        if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
        nearest = std::max(nearest, a.z() + s * u.z() + t * v.z());
    }
    return nearest;
}

TEST(SampleHits, AreTheNearestTrianglesOfASoup) {
    constexpr int kSize = 24, kSide = 3;
    const Soup soup = soup_of(200, kSize);
    std::vector<std::uint8_t> mask(kSize * kSize, 0);
    for (std::size_t p = 0; p < mask.size(); p += 2) mask[p] = 1;
    const auto hits = find_sample_hits(soup.vertices, soup.triangles, {kSize, kSide, mask}, {});
    ASSERT_EQ(hits.size(), mask.size() / 2 * kSide * kSide);
    std::size_t next = 0, met = 0;
    for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
            if (mask[std::size_t(row * kSize + column)] == 0) continue;
            for (int i = 0; i < kSide * kSide; ++i) {
                const double x = column + (i % kSide + 0.5) / kSide;
                const double y = row + (i / kSide + 0.5) / kSide;
                const SampleHit& hit = hits[next++];
                const double expected = nearest_depth(soup, x, y);
                if (hit.triangle == SampleHit::kNone) {
                    EXPECT_LT(expected, -1e29);
                    continue;
                }
                ++met;
                const auto& [a, b, c] = soup.triangles[hit.triangle];
                const Vec3f point = (1 - hit.u - hit.v) * soup.vertices[a] +
                                    hit.u * soup.vertices[b] + hit.v * soup.vertices[c];
                EXPECT_NEAR(point.x(), x, 1e-3);
                EXPECT_NEAR(point.y(), y, 1e-3);
                EXPECT_NEAR(point.z(), expected, 2e-3);
            }
        }
    }
    EXPECT_GT(met, hits.size() / 2);
}

TEST(SampleHits, SeeNothingThroughTheSeamsOfASurface) {
    // Edges run through the middles of pixels, in all directions.
    constexpr std::uint32_t kCells = 16;
    Soup fan;
    fan.vertices.emplace_back(8.5f, 8.5f, 0.0f);
    for (std::uint32_t i = 0; i < kCells; ++i) {
        const double angle = 2.0 * M_PI * i / kCells;
        fan.vertices.emplace_back(8.5f + 40.0f * static_cast<float>(std::cos(angle)),
                                  8.5f + 40.0f * static_cast<float>(std::sin(angle)), 0.0f);
        fan.triangles.push_back({0, i + 1, (i + 1) % kCells + 1});
    }
    for (const SampleHit& hit : find_sample_hits(fan.vertices, fan.triangles, {17, 4, {}}, {})) {
        EXPECT_NE(hit.triangle, SampleHit::kNone);
    }
    for (const SampleHit& hit : find_sample_hits(fan.vertices, fan.triangles, {17, 1, {}}, {})) {
        EXPECT_NE(hit.triangle, SampleHit::kNone);
    }
}

TEST(SampleHits, OfSeveralAtOneDepthAreTheFirst) {
    Soup twice;
    twice.vertices = {{0, 0, 1}, {20, 0, 1}, {0, 20, 1}};
    twice.triangles = {{0, 1, 2}, {1, 2, 0}};
    const auto hits = find_sample_hits(twice.vertices, twice.triangles, {8, 1, {}}, {});
    for (const SampleHit& hit : hits) EXPECT_EQ(hit.triangle, 0u);
}

}  // namespace
}  // namespace ossuary::index
