// What is kept of a geometry is the same to the last bit, whoever's reader it came through.

#include <gtest/gtest.h>

#include "engine/core/whole_file.h"
#include "engine/mesh/write_mesh.h"
#include "index/describe_model.h"
#include "tests/index/same_bits.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

mesh::TriangleMesh as_floats(mesh::TriangleMesh mesh) {
    for (Vec3& vertex : mesh.vertices) {
        for (double& x : vertex) {
            // GCC 12 leaves out the rounding where it vectorises such a loop.
            const volatile float rounded = static_cast<float>(x);
            x = double{rounded};
        }
    }
    return mesh;
}

void expect_same_in_foreign_formats(const mesh::TriangleMesh& mesh) {
    const test::TemporaryFolder folder;
    const auto package = test::write_three_mf(
        folder.path() / "model.3mf",
        test::three_mf_part(test::three_mf_object(mesh), "<item objectid=\"1\"/>"));
    const auto three_mf = read_whole_file(package);
    ASSERT_TRUE(three_mf);
    const std::string glb = test::to_plain_glb(mesh);
    ModelReader reader;
    const auto off = describe_model({mesh::to_off(mesh), "off"}, {});
    ASSERT_TRUE(off) << off.error().message;
    for (const auto& [name, bytes] :
         {std::pair("glb", std::string_view(glb)), std::pair("3mf", three_mf->view())}) {
        SCOPED_TRACE(name);
        const auto other = describe_model({bytes, name, {}, &reader}, {});
        ASSERT_TRUE(other) << other.error().message;
        test::expect_same_bits(other->descriptor, off->descriptor);
    }
}

TEST(ForeignGeometry, GivesTheSameDescriptors) {
    expect_same_in_foreign_formats(as_floats(test::capsule_tree_mesh()));
    expect_same_in_foreign_formats(as_floats(test::torus_mesh(1.0, 0.3)));
}

TEST(ForeignGeometry, GivesTheSameDescriptorsOfBenchmarkModels) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const char* name : {"81.off", "281.off", "390.off"}) {
        SCOPED_TRACE(name);
        const auto read = mesh::read_mesh(data / "princeton-segmentation" / "off" / name);
        ASSERT_TRUE(read) << read.error().message;
        expect_same_in_foreign_formats(as_floats(read->mesh));
    }
}

}  // namespace
}  // namespace ossuary::index
