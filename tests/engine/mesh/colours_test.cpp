// What becomes of a mesh's colours on its way through the stages.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

#include "engine/mesh/body.h"
#include "engine/mesh/cluster_vertices.h"
#include "engine/mesh/colours_on.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/mend_surface.h"
#include "engine/mesh/model_objects.h"
#include "engine/mesh/orient.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/weld.h"
#include "engine/mesh/write_mesh.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::mesh {
namespace {

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// A colour that says where a point of the unit sphere is.
Colour colour_of(const Vec3& point) {
    return {byte_of(0.5 + 0.5 * point.x()), byte_of(0.5 + 0.5 * point.y()),
            byte_of(0.5 + 0.5 * point.z())};
}

TriangleMesh with_smooth_colours(TriangleMesh mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.corners(t);
        mesh.corner_colours.push_back({colour_of(a), colour_of(b), colour_of(c)});
    }
    return mesh;
}

/// Above the equator red, below it blue.
TriangleMesh with_flat_colours(TriangleMesh mesh) {
    constexpr Colour kRed = {255, 0, 0}, kBlue = {0, 0, 255};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.corners(t);
        const Colour& colour = (a + b + c).z() > 0.0 ? kRed : kBlue;
        mesh.corner_colours.push_back({colour, colour, colour});
    }
    return mesh;
}

/// How much the corners' colours differ from those of their places, at most.
int greatest_error(const TriangleMesh& mesh) {
    int greatest = 0;
    EXPECT_EQ(mesh.corner_colours.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.corner_colours.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Colour expected = colour_of(mesh.corners(t)[corner]);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                greatest = std::max(greatest, std::abs(mesh.corner_colours[t][corner][channel] -
                                                       expected[channel]));
            }
        }
    }
    return greatest;
}

TEST(Colours, StayAtTheirCornersThroughEveryStage) {
    const TriangleMesh mesh = with_smooth_colours(test::as_soup(test::sphere_mesh(3)));
    EXPECT_EQ(greatest_error(mesh), 0);
    EXPECT_EQ(greatest_error(weld(mesh).mesh), 0);
    EXPECT_EQ(greatest_error(mend_surface(mesh).mesh), 0);
    TriangleMesh turned = weld(mesh).mesh;
    for (std::size_t t = 0; t < turned.triangles.size(); t += 3) turned.turn_over(t);
    EXPECT_EQ(greatest_error(turned), 0);
    EXPECT_EQ(greatest_error(orient(turned).mesh), 0);
    EXPECT_EQ(greatest_error(mend_surface(turned).mesh), 0);
    EXPECT_EQ(greatest_error(object_mesh(mesh, {"", 7, 30})), 0);
}

TEST(Colours, StayWithTheBodyWhereSpecksAreLeftOut) {
    TriangleMesh mesh = test::sphere_mesh(3);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.begin(), Vec3(50, 50, 50));
    mesh.vertices.insert(mesh.vertices.begin() + 1, {Vec3(50.01, 50, 50), Vec3(50, 50.01, 50)});
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& vertex : triangle) vertex += 3;
    }
    mesh.triangles.insert(mesh.triangles.begin(), {0, 1, 2});
    mesh.face_of_triangle = {};
    const Body body = find_body(with_smooth_colours(mesh));
    ASSERT_TRUE(body.mesh);
    ASSERT_EQ(body.triangles_apart, 1U);
    EXPECT_EQ(body.mesh->vertices.size(), first + 3);
    EXPECT_EQ(greatest_error(*body.mesh), 0);
}

TEST(Colours, ChangeNothingOfTheGeometry) {
    const TriangleMesh plain = test::as_soup(test::sphere_mesh(5));
    const TriangleMesh coloured = with_smooth_colours(plain);
    const auto same = [](const TriangleMesh& a, const TriangleMesh& b) {
        EXPECT_EQ(a.vertices, b.vertices);
        EXPECT_EQ(a.triangles, b.triangles);
        EXPECT_EQ(a.face_of_triangle, b.face_of_triangle);
    };
    same(weld(coloured).mesh, weld(plain).mesh);
    same(mend_surface(coloured).mesh, mend_surface(plain).mesh);
    same(decimate(coloured), decimate(plain));
    same(cluster_vertices(coloured, 500), cluster_vertices(plain, 500));
}

TEST(Colours, OfAPreviewAreThoseOfTheSurfaceThere) {
    const TriangleMesh mesh = with_smooth_colours(test::sphere_mesh(5));
    const TriangleMesh coarse = decimate(mesh, {.max_triangles = 500});
    ASSERT_LE(coarse.triangles.size(), 500U);
    EXPECT_LE(greatest_error(coarse), 3);
}

TEST(Colours, OfAPreviewStayFlatWhereTheyWere) {
    const TriangleMesh mesh = with_flat_colours(test::sphere_mesh(5));
    const TriangleMesh coarse = decimate(mesh, {.max_triangles = 500});
    ASSERT_TRUE(has_flat_colours(coarse));
    for (std::size_t t = 0; t < coarse.triangles.size(); ++t) {
        const auto [a, b, c] = coarse.corners(t);
        const double height = (a + b + c).z() / 3.0;
        if (std::abs(height) < 0.05) continue;
        EXPECT_EQ(coarse.corner_colours[t][0][0], height > 0.0 ? 255 : 0);
    }
}

TEST(Colours, OfASmallMeshAreKeptAsTheyAre) {
    const TriangleMesh mesh = with_smooth_colours(test::sphere_mesh(2));
    // Triangles may come in another order, each with its own colours.
    const auto triangles_of = [](const TriangleMesh& of) {
        std::multiset<std::vector<double>> triangles;
        for (std::size_t t = 0; t < of.triangles.size(); ++t) {
            std::vector<double> numbers;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& at = of.vertices[of.triangles[t][k]];
                numbers.insert(numbers.end(), at.begin(), at.end());
                const Colour& colour = of.corner_colours[t][k];
                numbers.insert(numbers.end(), colour.begin(), colour.end());
            }
            triangles.insert(std::move(numbers));
        }
        return triangles;
    };
    const TriangleMesh kept = decimate(mesh);
    ASSERT_EQ(kept.corner_colours.size(), kept.triangles.size());
    EXPECT_EQ(triangles_of(kept), triangles_of(mesh));
    EXPECT_TRUE(decimate(test::sphere_mesh(2)).corner_colours.empty());
    EXPECT_TRUE(decimate(test::sphere_mesh(5)).corner_colours.empty());
}

TEST(Colours, ComeBackAfterWriting) {
    for (const TriangleMesh& mesh :
         {with_smooth_colours(test::sphere_mesh(2)), with_flat_colours(test::sphere_mesh(2)),
          test::sphere_mesh(2)}) {
        for (const std::string& bytes : {to_off(mesh), to_ply(mesh)}) {
            const auto read = read_mesh(bytes, "written");
            ASSERT_TRUE(read) << read.error().message;
            EXPECT_EQ(read->mesh.vertices, mesh.vertices);
            EXPECT_EQ(read->mesh.corner_colours, mesh.corner_colours);
        }
    }
}

TEST(Colours, OfAPolygonBelongToItsCorners) {
    // A dart: the triangulation begins elsewhere than the file.
    const auto read = read_mesh(
        "COFF\n4 1 0\n0 0 0 255 0 0\n2 1 0 0 255 0\n0 2 0 0 0 255\n.5 1 0 255 255 255\n4 0 1 2 3\n",
        "dart");
    ASSERT_TRUE(read) << read.error().message;
    const std::array<Colour, 4> of_vertex = {
        {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}}};
    ASSERT_EQ(read->mesh.corner_colours.size(), 2U);
    for (std::size_t t = 0; t < 2; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            EXPECT_EQ(read->mesh.corner_colours[t][corner],
                      of_vertex[read->mesh.triangles[t][corner]]);
        }
    }
}

TEST(Colours, AsNumbersAreSharesUnlessOneIsLarger) {
    NumberColours shares;
    shares.set(1, {1.0F, 0.5F, -1.0F});
    shares.set(2, {std::nanf(""), 0.0F, 0.0F});
    EXPECT_EQ(shares.take(3), (std::vector<Colour>{kPlainColour, {255, 128, 0}, kPlainColour}));
    NumberColours bytes;
    bytes.set(0, {1.0F, 2.0F, 300.0F});
    EXPECT_EQ(bytes.take(1), (std::vector<Colour>{{1, 2, 255}}));
    EXPECT_TRUE(NumberColours().take(5).empty());
}

}  // namespace
}  // namespace ossuary::mesh
