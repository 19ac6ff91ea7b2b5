// One geometry in four formats: what is kept of it is the same to the last bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "index/describe_model.h"
#include "tests/index/same_bits.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

/// With coordinates that floats hold, and vertices in an order that no face suggests.
mesh::TriangleMesh as_floats_in_disorder(mesh::TriangleMesh mesh) {
    std::vector<std::uint32_t> place(mesh.vertices.size());
    std::iota(place.begin(), place.end(), 0u);
    std::shuffle(place.begin(), place.end(), std::mt19937(3));
    std::vector<Vec3> vertices(place.size());
    for (std::size_t v = 0; v < place.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            // GCC 12 leaves out the rounding where it vectorises such a loop.
            const volatile float rounded = static_cast<float>(mesh.vertices[v][axis]);
            vertices[place[v]][axis] = double{rounded};
        }
    }
    mesh.vertices = std::move(vertices);
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) corner = place[corner];
    }
    return mesh;
}

void expect_same_in_every_format(const mesh::TriangleMesh& mesh) {
    const auto off = describe_model({mesh::to_off(mesh), "off"}, {});
    ASSERT_TRUE(off) << off.error().message;
    for (const auto& [name, bytes] :
         {std::pair("ply", mesh::to_ply(mesh)), std::pair("obj", mesh::to_obj(mesh)),
          std::pair("stl", mesh::to_stl(mesh))}) {
        SCOPED_TRACE(name);
        const auto other = describe_model({bytes, name}, {});
        ASSERT_TRUE(other) << other.error().message;
        test::expect_same_bits(other->descriptor, off->descriptor);
    }
}

TEST(SameGeometry, GivesTheSameDescriptorsInEveryFormat) {
    expect_same_in_every_format(as_floats_in_disorder(test::capsule_tree_mesh()));
    expect_same_in_every_format(as_floats_in_disorder(test::torus_mesh(1.0, 0.3)));
}

TEST(SameGeometry, GivesTheSameDescriptorsOfBenchmarkModelsInEveryFormat) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const char* name : {"81.off", "281.off", "390.off"}) {
        SCOPED_TRACE(name);
        const auto read = mesh::read_mesh(data / "princeton-segmentation" / "off" / name);
        ASSERT_TRUE(read) << read.error().message;
        expect_same_in_every_format(as_floats_in_disorder(read->mesh));
    }
}

}  // namespace
}  // namespace ossuary::index
