#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/matching/match_chain_codes.h"
#include "engine/matching/match_skeletons.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/skeleton/skeletonize.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::matching {
namespace {

struct Model {
    int kind;
    SkeletonDescriptor descriptor;
};

/// Four models each of the ants, teddies, pliers and armadillos.
std::vector<Model> read_models(const std::filesystem::path& data) {
    std::vector<Model> models;
    for (const int first : {81, 161, 201, 281}) {
        for (int i = first; i < first + 4; ++i) {
            const auto file =
                data / "princeton-segmentation" / "off" / (std::to_string(i) + ".off");
            const auto read = mesh::read_mesh(file);
            if (!read.ok()) {
                ADD_FAILURE() << read.error().message;
                continue;
            }
            skeleton::SkeletonizeOptions options;
            options.voxelize.resolution = 64;
            const auto skeleton = skeleton::skeletonize(read->mesh, options);
            if (!skeleton.ok()) {
                ADD_FAILURE() << skeleton.error().message;
                continue;
            }
            const double scale = std::sqrt(mesh::measure(read->mesh).surface_area) /
                                 skeleton->solid.world_from_grid.voxel_size;
            models.push_back({first, describe_skeleton(skeleton->refined, scale)});
        }
    }
    return models;
}

/// Share of the models whose nearest other model is of their kind.
template <typename Distance>
double nearest_neighbor(const std::vector<Model>& models, const Distance& distance) {
    int right = 0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        double least = 1e9;
        int kind = 0;
        for (std::size_t j = 0; j < models.size(); ++j) {
            if (i == j) continue;
            const double d = distance(models[i].descriptor, models[j].descriptor);
            if (d < least) {
                least = d;
                kind = models[j].kind;
            }
        }
        right += kind == models[i].kind ? 1 : 0;
    }
    return right / static_cast<double>(models.size());
}

TEST(BenchmarkModels, FindTheirOwnKind) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const std::vector<Model> models = read_models(data);
    ASSERT_EQ(models.size(), 16U);
    SkeletonMatchWorkspace skeleton;
    ChainCodeMatchWorkspace chain_code;
    EXPECT_EQ(nearest_neighbor(models,
                               [&](const SkeletonDescriptor& a, const SkeletonDescriptor& b) {
                                   return skeleton_distance(a, b, {}, skeleton);
                               }),
              1.0);
    EXPECT_GE(nearest_neighbor(models,
                               [&](const SkeletonDescriptor& a, const SkeletonDescriptor& b) {
                                   return chain_code_distance(a, b, {}, chain_code);
                               }),
              0.75);
}

}  // namespace
}  // namespace ossuary::matching
