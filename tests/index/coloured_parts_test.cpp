#include "index/coloured_parts.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

TEST(ColouredParts, GivesEachOfTwentyPartsItsOwnColour) {
    std::set<std::array<std::uint8_t, 3>> colours;
    for (std::uint32_t part = 0; part < 20; ++part) colours.insert(part_colour(part));
    EXPECT_EQ(colours.size(), 20u);
}

TEST(ColouredParts, WritesVerticesAndColouredFaces) {
    const mesh::TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    std::vector<std::uint32_t> labels(box.triangles.size(), 0);
    labels.back() = 1;
    const std::string ply =
        mesh::to_ply(box, part_colours(decomposition::dense_segmentation(labels)));
    const std::size_t body = ply.find("end_header\n") + std::strlen("end_header\n");
    constexpr std::size_t kVertexBytes = 24, kFaceBytes = 1 + 12 + 3;
    ASSERT_EQ(ply.size(),
              body + kVertexBytes * box.vertices.size() + kFaceBytes * box.triangles.size());
    double z = 0.0;
    std::memcpy(&z, ply.data() + body + kVertexBytes - sizeof(double), sizeof(double));
    EXPECT_EQ(z, box.vertices[0].z());
    const auto colour = part_colour(1);
    EXPECT_EQ(std::memcmp(ply.data() + ply.size() - 3, colour.data(), 3), 0);
    EXPECT_NE(std::memcmp(ply.data() + ply.size() - 3 - kFaceBytes, colour.data(), 3), 0);
}

}  // namespace
}  // namespace ossuary::index
