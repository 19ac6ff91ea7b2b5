#include "engine/mesh/mend_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/weld.h"
#include "tests/engine/mesh/built_meshes.h"

namespace ossuary::test {
namespace {

using mesh::mend_surface;
using mesh::MendedSurface;
using mesh::TriangleMesh;

TriangleMesh outer_and_inner_shell() {
    TriangleMesh inner = moved(sphere_mesh(), some_rotation(), 0.5, Vec3::Zero());
    for (auto& triangle : inner.triangles) std::swap(triangle[1], triangle[2]);
    return joined(sphere_mesh(), inner);
}

/// A cube without its top.
TriangleMesh open_cube() {
    TriangleMesh mesh = cube_mesh();
    std::erase_if(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
        return std::all_of(t.begin(), t.end(), [&](auto v) { return mesh.vertices[v].z() == 1.0; });
    });
    return mesh;
}

std::vector<TriangleMesh> some_surfaces() {
    return {cube_mesh(),
            torus_mesh(),
            joined(torus_mesh(), moved(sphere_mesh(), some_rotation(), 1, Vec3(9, 0, 0))),
            open_cube(),
            square_mesh(4),
            moebius_mesh(),
            outer_and_inner_shell()};
}

/// Each chosen triangle with two of its corners, not always the same ones, exchanged.
TriangleMesh with_turned(TriangleMesh mesh, const std::function<bool(std::size_t)>& is_chosen) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (is_chosen(t)) std::swap(mesh.triangles[t][t % 3], mesh.triangles[t][(t + 1) % 3]);
    }
    return mesh;
}

TriangleMesh shifted_at_random(TriangleMesh mesh, double distance) {
    std::mt19937_64 random(5);
    for (Vec3& vertex : mesh.vertices) {
        for (double& x : vertex) x += uniform(random, -distance, distance);
    }
    return mesh;
}

std::size_t count_of(const MendedSurface& surface, const std::string& code) {
    for (const auto& warning : mending_warnings(surface)) {
        if (warning.code == code) return warning.count;
    }
    return 0;
}

void expect_same(const MendedSurface& a, const MendedSurface& b) {
    EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

TEST(MendSurface, KeepsSoundSurfaces) {
    for (const TriangleMesh& mesh : {cube_mesh(), torus_mesh(), sphere_mesh()}) {
        const MendedSurface surface = mend_surface(mesh);
        EXPECT_TRUE(mending_warnings(surface).empty());
        ASSERT_EQ(surface.mesh.triangles.size(), mesh.triangles.size());
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            EXPECT_EQ(surface.triangle_of[t], t);
            TriangleMesh::Triangle triangle = mesh.triangles[t];
            for (std::uint32_t& vertex : triangle) vertex = surface.vertex_of[vertex];
            const auto& mended = surface.mesh.triangles[t];
            std::rotate(triangle.begin(), std::find(triangle.begin(), triangle.end(), mended[0]),
                        triangle.end());
            EXPECT_EQ(triangle, mended);
        }
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            EXPECT_EQ(surface.mesh.vertices[surface.vertex_of[v]], mesh.vertices[v]);
        }
    }
}

TEST(MendSurface, DoesNotDependOnWhichWayFacesLie) {
    for (const TriangleMesh& mesh : some_surfaces()) {
        const MendedSurface sound = mend_surface(mesh);
        const auto all = [](std::size_t) { return true; };
        expect_same(mend_surface(with_turned(mesh, all)), sound);
        expect_same(mend_surface(with_turned(mesh, [](std::size_t t) { return t % 7 == 3; })),
                    sound);
        expect_same(mend_surface(with_turned(mesh, [](std::size_t t) { return t * t % 3 == 1; })),
                    sound);
        expect_same(mend_surface(as_soup(with_turned(mesh, all))), sound);
    }
}

TEST(MendSurface, DoesNotDependOnWhetherFacesComeTwiceOrShareVertices) {
    for (const TriangleMesh& mesh : some_surfaces()) {
        const MendedSurface sound = mend_surface(mesh);
        expect_same(mend_surface(as_soup(mesh)), sound);
        TriangleMesh twice = mesh;
        twice.triangles.insert(twice.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
        const std::size_t count = mesh.triangles.size();
        for (const TriangleMesh& copy :
             {twice, as_soup(twice),
              with_turned(twice, [=](std::size_t t) { return t >= count; })}) {
            const MendedSurface surface = mend_surface(copy);
            expect_same(surface, sound);
            for (std::uint32_t t = 0; t < count; ++t) {
                EXPECT_EQ(surface.triangle_of[t], t);
                EXPECT_EQ(surface.triangle_of[t + count], t);
            }
            EXPECT_EQ(count_of(surface, "repeated_triangles"), count);
        }
    }
}

TEST(MendSurface, ClosesSeamsThatDifferInTheLastDigits) {
    for (const TriangleMesh& mesh : {cube_mesh(), torus_mesh(), sphere_mesh()}) {
        const double size = mesh::measure(mesh).diagonal;
        for (const double share : {1e-9, 1e-7, 1e-6}) {
            const MendedSurface surface =
                mend_surface(shifted_at_random(as_soup(mesh), share * size));
            EXPECT_EQ(surface.mesh.vertices.size(), mesh.vertices.size()) << share;
            EXPECT_EQ(surface.mesh.triangles.size(), mesh.triangles.size()) << share;
            EXPECT_EQ(mesh::inspect(surface.mesh).genus, mesh::inspect(mesh).genus) << share;
        }
    }
}

TEST(MendSurface, LeavesWhatIsSmallOrThinAsItIs) {
    // Edges of a millionth of the size, and a plate of a hundred-thousandth.
    TriangleMesh fine = moved(sphere_mesh(), some_rotation(), 4e-5, Vec3(3, 3, 3));
    TriangleMesh plate = cube_mesh();
    for (Vec3& vertex : plate.vertices) vertex.z() *= 1e-4;
    for (const TriangleMesh& detail : {fine, plate}) {
        const TriangleMesh mesh = joined(torus_mesh(), detail);
        EXPECT_EQ(mend_surface(mesh).mesh.vertices.size(), mesh.vertices.size());
        EXPECT_EQ(mend_surface(as_soup(mesh)).mesh.vertices.size(), mesh.vertices.size());
    }
}

TEST(MendSurface, DoesNotLetWhatIsFarAwayCoarsenIt) {
    const TriangleMesh body = sphere_mesh();
    TriangleMesh speck = moved(corner_tetrahedron(), some_rotation(), 1e-3, Vec3(1e7, 0, 0));
    TriangleMesh point = body;  // a face that is a point
    point.vertices.emplace_back(1e7, 0, 0);
    const auto last = static_cast<std::uint32_t>(point.vertices.size() - 1);
    point.triangles.push_back({last, last, last});
    for (const TriangleMesh& mesh : {joined(body, speck), point}) {
        EXPECT_EQ(mend_surface(mesh).mesh.vertices.size(), mesh.vertices.size());
    }
}

TEST(MendSurface, SaysHowManyFacesLieInsideOut) {
    const TriangleMesh torus = with_faces(torus_mesh());
    const std::size_t count = torus.triangles.size();
    const auto turned = [&](const TriangleMesh& mesh, std::size_t of_each) {
        return count_of(
            mend_surface(with_turned(mesh, [=](std::size_t t) { return t % of_each == 0; })),
            "turned_faces");
    };
    EXPECT_EQ(turned(torus, 1), count);
    EXPECT_EQ(turned(torus, 50), (count + 49) / 50);
    EXPECT_EQ(turned(outer_and_inner_shell(), 10'000), 1U) << "the cavity is no fault";
    EXPECT_EQ(turned(square_mesh(4), 1), 0U) << "a flat sheet has no inside";
    EXPECT_EQ(turned(square_mesh(4), 10'000), 1U);
    TriangleMesh quads = torus;  // as from a file of quadrangles
    quads.face_count = static_cast<std::uint32_t>(count / 2);
    for (std::uint32_t& face : quads.face_of_triangle) face /= 2;
    EXPECT_EQ(turned(quads, 1), count / 2);
}

TEST(MendSurface, TurnsPatchesOver) {
    MendedSurface surface = mend_surface(joined(sphere_mesh(), open_cube()));
    ASSERT_EQ(surface.patches.size(), 2U);
    EXPECT_TRUE(surface.patches[0].closed);
    EXPECT_FALSE(surface.patches[1].closed);
    const double volume = mesh::measure(surface.mesh).signed_volume;
    turn_over(surface, {true, true});
    EXPECT_DOUBLE_EQ(mesh::measure(surface.mesh).signed_volume, -volume);
    EXPECT_EQ(surface.patches[0].turned, surface.patches[0].triangles);
    turn_over(surface, {true, false});
    EXPECT_EQ(surface.patches[0].turned, 0U);
    EXPECT_EQ(std::accumulate(surface.turned.begin(), surface.turned.end(), std::size_t{0}),
              surface.patches[1].triangles);
}

TEST(MendSurface, TakesWhatHasNoExtent) {
    EXPECT_TRUE(mend_surface(TriangleMesh{}).mesh.empty());
    TriangleMesh mesh;
    mesh.vertices = {{1, 1, 1}, {2, 2, 2}};
    mesh.triangles = {{0, 0, 0}, {0, 1, 1}, {0, 1, 1}};
    const MendedSurface surface = mend_surface(mesh);
    EXPECT_EQ(surface.mesh.triangles.size(), 3U);
    EXPECT_EQ(surface.triangle_of, (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace ossuary::test
