#include "index/thumbnail/thumbnail.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>

#include "engine/mesh/read_mesh.h"
#include "tests/engine/mesh/built_meshes.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::index {
namespace {

using test::cube_mesh;
using test::moved;
using test::sphere_mesh;
using test::torus_mesh;

struct Picture {
    int width = 0;
    int height = 0;
    bool has_alpha = false;
    std::vector<std::uint8_t> rgba;

    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return rgba.data() + 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
    }
    [[nodiscard]] double coverage() const {
        double sum = 0;
        for (std::size_t i = 3; i < rgba.size(); i += 4) sum += rgba[i] / 255.0;
        return sum / (double(width) * height);
    }
    /// Left, top, right and bottom of what is not transparent.
    [[nodiscard]] std::array<int, 4> extent() const {
        std::array<int, 4> box = {width, height, -1, -1};
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (at(x, y)[3] == 0) continue;
                box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x),
                       std::max(box[3], y)};
            }
        }
        return box;
    }
};

Picture decode(const std::vector<std::uint8_t>& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Picture picture;
    if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) return picture;
    picture.has_alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    image.format = PNG_FORMAT_RGBA;
    picture.width = int(image.width);
    picture.height = int(image.height);
    picture.rgba.resize(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr);
    return picture;
}

Picture draw(const mesh::TriangleMesh& mesh, const ThumbnailOptions& options = {}) {
    const auto png = render_thumbnail(mesh, options);
    EXPECT_TRUE(png) << png.error().message;
    return png ? decode(*png) : Picture{};
}

double mean_difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
    return sum / double(a.rgba.size());
}

TEST(Thumbnail, IsASquarePngWithTransparentCorners) {
    const Picture picture = draw(torus_mesh());
    EXPECT_EQ(picture.width, 256);
    EXPECT_EQ(picture.height, 256);
    EXPECT_TRUE(picture.has_alpha);
    for (const int x : {0, 255}) {
        for (const int y : {0, 255}) EXPECT_EQ(picture.at(x, y)[3], 0);
    }
}

TEST(Thumbnail, FillsThePictureUpToTheMargin) {
    ThumbnailOptions options;
    options.size = 200;
    options.margin = 0.1;
    for (const mesh::TriangleMesh& mesh :
         {cube_mesh(), torus_mesh(), moved(cube_mesh(), test::some_rotation(), 1e-6, Vec3(5, 5, 5)),
          moved(sphere_mesh(), Mat3::Identity(), 1e9, Vec3(-3e10, 1, 1))}) {
        const auto [left, top, right, bottom] = draw(mesh, options).extent();
        const int widest = std::max(right - left, bottom - top) + 1;
        EXPECT_NEAR(widest, 160, 2);
        EXPECT_NEAR(left + right, 199, 2);
        EXPECT_NEAR(top + bottom, 199, 2);
    }
}

TEST(Thumbnail, ShowsASphereAsADisc) {
    const Picture picture = draw(sphere_mesh(5));
    const double diameter = 1 - 2 * ThumbnailOptions{}.margin;
    EXPECT_NEAR(picture.coverage(), std::numbers::pi / 4 * diameter * diameter, 0.003);
    EXPECT_EQ(picture.at(128, 128)[3], 255);
    // Light comes from above left.
    EXPECT_GT(picture.at(90, 70)[0], picture.at(166, 186)[0] + 30);
}

TEST(Thumbnail, ShadesCurvedSurfacesSmoothlyAndKeepsCreases) {
    // Over a coarse sphere neighbouring pixels differ little although its facets are large...
    const Picture sphere = draw(sphere_mesh(2));
    int steepest = 0;
    for (int y = 70; y < 186; ++y) {
        for (int x = 70; x < 186; ++x) {
            steepest = std::max(steepest, std::abs(sphere.at(x, y)[0] - sphere.at(x + 1, y)[0]));
        }
    }
    EXPECT_LE(steepest, 8);
    // ...while a cube shows three flat sides: nearly all pixels are of three colours.
    const Picture cube = draw(cube_mesh());
    std::map<int, int> of_color;
    int solid = 0;
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            if (cube.at(x, y)[3] != 255) continue;
            ++of_color[cube.at(x, y)[0]];
            ++solid;
        }
    }
    std::vector<int> counts;
    for (const auto& [color, count] : of_color) counts.push_back(count);
    std::sort(counts.rbegin(), counts.rend());
    ASSERT_GE(counts.size(), 3u);
    EXPECT_GT(counts[2], solid / 10);
    EXPECT_GT(counts[0] + counts[1] + counts[2], solid * 95 / 100);
}

TEST(Thumbnail, DoesNotCareWhichWayTrianglesFace) {
    const mesh::TriangleMesh mesh = torus_mesh();
    mesh::TriangleMesh turned = mesh;
    for (std::size_t t = 0; t < turned.triangles.size(); t += 2) {
        std::swap(turned.triangles[t][1], turned.triangles[t][2]);
    }
    EXPECT_LT(mean_difference(draw(mesh), draw(turned)), 0.1);
}

TEST(Thumbnail, ShadesASoupLikeTheSurfaceItMakesUp) {
    const mesh::TriangleMesh mesh = torus_mesh();
    EXPECT_EQ(draw(mesh).rgba, draw(test::as_soup(mesh)).rgba);
}

TEST(Thumbnail, IsTheSameEveryTimeWhereverAndHoweverLargeTheModel) {
    const mesh::TriangleMesh mesh = torus_mesh(50, 30);
    EXPECT_EQ(*render_thumbnail(mesh), *render_thumbnail(mesh));
    const mesh::TriangleMesh elsewhere = moved(mesh, Mat3::Identity(), 1000, Vec3(1e5, 2e5, -3e5));
    EXPECT_LT(mean_difference(draw(mesh), draw(elsewhere)), 0.05);
    EXPECT_LT(mean_difference(draw(mesh), draw(test::renumbered(mesh, 4))), 0.05);
}

TEST(Thumbnail, DoesNotLoseWiresThinnerThanAPixel) {
    // An upright rod, three tenths of a pixel wide, beside a cube.
    mesh::TriangleMesh rod = cube_mesh();
    for (Vec3& vertex : rod.vertices) vertex = Vec3(2 + 0.0026 * vertex.x(), 2 * vertex.y(), 0);
    ThumbnailOptions options;
    options.towards_viewer = Vec3::UnitZ();
    const Picture picture = draw(test::joined(cube_mesh(), rod), options);
    int rows_with_rod = 0;
    for (int y = 0; y < 256; ++y) {
        for (int x = 200; x < 256; ++x) {
            if (picture.at(x, y)[3] == 0) continue;
            ++rows_with_rod;
            break;
        }
    }
    EXPECT_GE(rows_with_rod, 228) << "the rod is unbroken over the height of the picture";
    EXPECT_LT(picture.coverage(), 0.3);
}

TEST(Thumbnail, PaintsABackgroundWhereOneIsAskedFor) {
    ThumbnailOptions options;
    options.background = {10, 200, 30};
    const Picture picture = draw(sphere_mesh(), options);
    EXPECT_FALSE(picture.has_alpha);
    EXPECT_EQ(picture.at(0, 0)[0], 10);
    EXPECT_EQ(picture.at(0, 0)[1], 200);
    EXPECT_EQ(picture.at(0, 0)[2], 30);
    EXPECT_NE(picture.at(128, 128)[1], 200);
}

TEST(Thumbnail, LooksFromWhereItIsTold) {
    mesh::TriangleMesh flag = cube_mesh();
    for (Vec3& vertex : flag.vertices) vertex = vertex.cwiseProduct(Vec3(1, 2, 0.1));
    ThumbnailOptions options;
    options.towards_viewer = Vec3::UnitZ();
    EXPECT_NEAR(draw(flag, options).coverage(), 0.9 * 0.45, 0.01);
    options.towards_viewer = Vec3::UnitX();
    EXPECT_NEAR(draw(flag, options).coverage(), 0.9 * 0.045, 0.01);
    options.towards_viewer = Vec3::UnitZ();
    options.up = Vec3::UnitX();
    const auto [left, top, right, bottom] = draw(flag, options).extent();
    EXPECT_GT(right - left, bottom - top);
}

TEST(Thumbnail, RefusesWhatHasNoPicture) {
    EXPECT_EQ(render_thumbnail(mesh::TriangleMesh{}).error().code, ErrorCode::kMeshEmpty);
    mesh::TriangleMesh line;
    line.vertices = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
    line.triangles = {{0, 1, 2}, {0, 0, 1}};
    EXPECT_EQ(render_thumbnail(line).error().code, ErrorCode::kMeshNoExtent);
    ThumbnailOptions options;
    options.size = 5;
    EXPECT_EQ(render_thumbnail(cube_mesh(), options).error().code, ErrorCode::kInvalidArgument);
    options = {};
    options.samples_per_side = 0;
    EXPECT_EQ(render_thumbnail(cube_mesh(), options).error().code, ErrorCode::kInvalidArgument);
    options = {};
    options.margin = 0.5;
    EXPECT_EQ(render_thumbnail(cube_mesh(), options).error().code, ErrorCode::kInvalidArgument);
    options = {};
    options.up = 2 * options.towards_viewer;
    EXPECT_EQ(render_thumbnail(cube_mesh(), options).error().code, ErrorCode::kInvalidArgument);
}

/// A square seen from above, each of its triangles with these colours at the corners.
Picture face_on(const mesh::CornerColours& colours) {
    mesh::TriangleMesh square = test::square_mesh(1);
    square.corner_colours.assign(square.triangles.size(), colours);
    ThumbnailOptions options;
    options.towards_viewer = Vec3::UnitZ();
    return draw(square, options);
}

TEST(Thumbnail, ShowsTheColoursOfTheMesh) {
    constexpr mesh::Colour kRed = {255, 0, 0}, kBlue = {0, 0, 255};
    const Picture red = face_on({kRed, kRed, kRed});
    const std::uint8_t* middle = red.at(100, 130);
    EXPECT_GT(middle[0], 150);
    EXPECT_LT(middle[1], 60);
    EXPECT_LT(middle[2], 60);
    const Picture mixed = face_on({kRed, kBlue, kBlue});
    const std::uint8_t* between = mixed.at(128, 128);
    EXPECT_GT(between[2], 100);
    EXPECT_LT(between[1], 60);
    mesh::TriangleMesh plain = test::square_mesh(1);
    ThumbnailOptions asked;
    asked.towards_viewer = Vec3::UnitZ();
    asked.triangle_colors.assign(plain.triangles.size(), kRed);
    plain.corner_colours.assign(plain.triangles.size(), {kBlue, kBlue, kBlue});
    EXPECT_EQ(draw(plain, asked).rgba, red.rgba) << "what is asked for comes first";
}

TEST(Thumbnail, TakesFlatDegenerateAndEnormousModels) {
    EXPECT_GT(draw(test::square_mesh(3)).coverage(), 0.1);
    mesh::TriangleMesh mesh = cube_mesh();
    mesh.triangles.push_back({0, 0, 5});
    mesh.triangles.push_back({1, 7, 1});
    mesh.vertices.emplace_back(1e60, 0, 0);  // that nothing uses
    EXPECT_EQ(draw(mesh).rgba, draw(cube_mesh()).rgba);
    EXPECT_GT(draw(moved(cube_mesh(), Mat3::Identity(), 1e60, Vec3::Zero())).coverage(), 0.3);
    EXPECT_GT(draw(moved(cube_mesh(), Mat3::Identity(), 1e-60, Vec3::Zero())).coverage(), 0.3);
    // A model that is seen edge on has a picture, if an empty one.
    ThumbnailOptions options;
    options.towards_viewer = Vec3::UnitX();
    EXPECT_EQ(draw(test::square_mesh(1), options).width, 256);
}

TEST(Thumbnail, DrawsSomeOfEachBenchmarkCollection) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const char* name :
         {"princeton-segmentation/off/1.off", "princeton-segmentation/off/385.off",
          "princeton-shape-train/off/m1544.off", "princeton-shape-train/off/m985.off"}) {
        const auto read = mesh::read_mesh(data / name);
        ASSERT_TRUE(read) << read.error().message;
        const Picture picture = draw(read->mesh);
        EXPECT_GT(picture.coverage(), 0.02) << name;
        EXPECT_LT(picture.coverage(), 0.95) << name;
    }
}

}  // namespace
}  // namespace ossuary::index
