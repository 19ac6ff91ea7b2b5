#include "index/parts_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "index/coloured_parts.h"
#include "index/thumbnail/thumbnail.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

using testing::ElementsAre;

constexpr int kCell = 48;

std::uint32_t big_endian_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k) word = word << 8 | bytes[at + k];
    return word;
}

decomposition::Segmentation labelled(const mesh::TriangleMesh& mesh, std::uint32_t of_the_first) {
    std::vector<std::uint32_t> labels(mesh.triangles.size(), 1 - of_the_first);
    for (std::size_t t = 0; t < labels.size() / 2; ++t) labels[t] = of_the_first;
    return {labels, 2};
}

TEST(PartsSheet, GivesPartsTheColoursOfThoseThatTheyShareMostWith) {
    const mesh::TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
    EXPECT_THAT(matching_colours(mesh, labelled(mesh, 0), labelled(mesh, 1)), ElementsAre(1, 0));
    const decomposition::Segmentation whole{std::vector<std::uint32_t>(mesh.triangles.size(), 0),
                                            1};
    EXPECT_THAT(matching_colours(mesh, whole, labelled(mesh, 0)), ElementsAre(0, 1));
}

TEST(PartsSheet, HasARowForEachModelAndAColumnForEachSegmentation) {
    const mesh::TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
    const SheetRow row{mesh, {labelled(mesh, 0), labelled(mesh, 1), labelled(mesh, 0)}};
    for (const std::size_t count : {1U, 8U, 9U}) {
        const auto png = parts_sheet(std::vector<SheetRow>(count, row), kCell);
        ASSERT_TRUE(png.ok()) << png.error().message;
        const std::size_t stacks = count > 8 ? 2 : 1;
        EXPECT_EQ(big_endian_at(*png, 16), kCell * 3 * stacks);
        EXPECT_EQ(big_endian_at(*png, 20), kCell * ((count + stacks - 1) / stacks));
    }
    EXPECT_EQ(parts_sheet({}, kCell).error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(parts_sheet(std::vector<SheetRow>(200, row), kCell).error().code,
              ErrorCode::kInvalidArgument);
}

TEST(PartsSheet, PicturesShowEachTriangleInItsColour) {
    const mesh::TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
    ThumbnailOptions options{.size = kCell};
    options.triangle_colors.assign(mesh.triangles.size(), {200, 0, 0});
    const auto red = render_pixels(mesh, options);
    ASSERT_TRUE(red.ok()) << red.error().message;
    std::size_t drawn = 0;
    for (std::size_t p = 0; p < red->bytes.size(); p += 4) {
        if (red->bytes[p + 3] == 0) continue;
        ++drawn;
        EXPECT_GT(red->bytes[p], red->bytes[p + 1] + 30);
    }
    EXPECT_GT(drawn, static_cast<std::size_t>(kCell * kCell / 5));
    options.triangle_colors.pop_back();
    EXPECT_EQ(render_pixels(mesh, options).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace ossuary::index
