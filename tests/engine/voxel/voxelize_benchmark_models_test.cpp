#include <gtest/gtest.h>

#include <string>

#include "engine/mesh/inspect.h"
#include "engine/mesh/read_mesh.h"
#include "engine/voxel/betti.h"
#include "engine/voxel/voxelize.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::voxel {
namespace {

TEST(VoxelizeBenchmarkModels, HaveTheGenusOfTheirMesh) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    // A human, a cup, glasses, an octopus, a table, a teddy, a mechanical part, a bearing: closed
    // manifolds without parts that touch.
    int checked = 0;
    for (const int id : {1, 21, 41, 130, 145, 165, 325, 345}) {
        const auto path = data / "princeton-segmentation" / "off" / (std::to_string(id) + ".off");
        const auto read = mesh::read_mesh(path);
        ASSERT_TRUE(read.ok()) << read.error().message;
        const mesh::MeshReport report = mesh::inspect(read->mesh);
        if (!report.genus.has_value()) continue;
        const auto solid = voxelize(read->mesh);
        ASSERT_TRUE(solid.ok()) << solid.error().message;
        EXPECT_EQ(solid->method, "winding");
        EXPECT_EQ(betti_numbers(solid->volume),
                  (BettiNumbers{1, static_cast<int>(*report.genus), 0}))
            << id;
        ++checked;
    }
    EXPECT_GE(checked, 6);
}

TEST(VoxelizeBenchmarkModels, GiveOneSolidOfEveryPolygonSoup) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    for (const int id : {5, 116, 400, 688, 768, 841, 988, 1050, 1331, 1625}) {
        const auto path =
            data / "princeton-shape-train" / "off" / ("m" + std::to_string(id) + ".off");
        if (!std::filesystem::exists(path)) continue;
        const auto read = mesh::read_mesh(path);
        ASSERT_TRUE(read.ok()) << read.error().message;
        const auto solid = voxelize(read->mesh, {.resolution = 64});
        ASSERT_TRUE(solid.ok()) << id << ": " << solid.error().message;
        const BettiNumbers betti = betti_numbers(solid->volume);
        EXPECT_EQ(betti.components, 1) << id;
        EXPECT_EQ(betti.cavities, 0) << id;
        const auto again = voxelize(test::renumbered(read->mesh, 1), {.resolution = 64});
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(again->volume, solid->volume) << id;
    }
}

}  // namespace
}  // namespace ossuary::voxel
