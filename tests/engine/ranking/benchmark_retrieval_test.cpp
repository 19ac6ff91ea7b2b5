#include <gtest/gtest.h>

#include "engine/core/parallel.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/ranker.h"
#include "engine/ranking/retrieval_metrics.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::ranking {
namespace {

constexpr std::size_t kPerClass = 3;

TEST(BenchmarkRetrieval, FindsTheClassFarMoreOftenThanChance) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const auto folder = data / "princeton-segmentation";
    const auto classification = read_classification(folder / "segmentation-thesis10.cla");
    ASSERT_TRUE(classification.ok());
    std::vector<std::string> labels;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : classification->classes) {
        // Every sixth model, so that the poses and builds of a class differ.
        for (std::size_t i = 0; i < kPerClass; ++i) {
            labels.push_back(entry.name);
            files.push_back(folder / "off" / candidate_file_names(entry.models[6 * i]).front());
        }
    }
    std::vector<descriptor::ModelDescriptor> models(files.size());
    parallel_for(files.size(), 2, [&](std::size_t i) {
        const auto mesh = mesh::read_mesh(files[i]);
        if (!mesh) return;
        auto description = descriptor::describe(mesh->mesh);
        if (description) models[i] = std::move(description->descriptor);
    });
    std::vector<const descriptor::ModelDescriptor*> collection;
    for (std::size_t i = 0; i < models.size(); ++i) {
        ASSERT_FALSE(models[i].globals.empty()) << files[i];
        collection.push_back(&models[i]);
    }

    const CollectionStatistics statistics = *collection_statistics(collection, 2);
    const auto report = [&](RankerKind ranker) {
        return evaluate_retrieval(
            *distance_matrix(collection, statistics, {.ranker = ranker, .jobs = 2}), labels);
    };
    // Chance is 2 in 29, .07.
    const RetrievalReport chain_code = report(RankerKind::kChainCode);
    EXPECT_GE(chain_code.mean.nearest_neighbor, 0.3);
    const RetrievalReport skeleton = report(RankerKind::kSkeleton);
    EXPECT_GE(skeleton.mean.nearest_neighbor, 0.8);
    EXPECT_GE(skeleton.mean.first_tier, 0.7);
    const RetrievalReport hybrid = report(RankerKind::kHybrid);
    EXPECT_GE(hybrid.mean.nearest_neighbor, 0.8);
    EXPECT_GE(hybrid.mean.first_tier, 0.7);
    // Three models a class are too few to tell `hybrid` from `skeleton`.
    EXPECT_GE(skeleton.mean.mean_average_precision, chain_code.mean.mean_average_precision + 0.2);
    EXPECT_GE(hybrid.mean.mean_average_precision, chain_code.mean.mean_average_precision + 0.2);
}

}  // namespace
}  // namespace ossuary::ranking
