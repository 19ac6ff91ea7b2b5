#include "engine/ranking/ranker.h"
#include "engine/ranking/explain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/ranking/retrieval_metrics.h"
#include "tests/engine/ranking/built_models.h"

namespace ossuary::ranking {
namespace {

constexpr std::size_t kFamilies = 6;
constexpr std::size_t kMembers = 4;

/// Six families of four models; built once for all tests.
class Ranker : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        models_ = new std::vector<descriptor::ModelDescriptor>(
            test::built_collection(kFamilies, kMembers));
    }
    static void TearDownTestSuite() {
        delete models_;
        models_ = nullptr;
    }
    [[nodiscard]] static const std::vector<descriptor::ModelDescriptor>& models() {
        return *models_;
    }
    [[nodiscard]] static std::vector<const descriptor::ModelDescriptor*> collection() {
        return test::pointers(models());
    }
    [[nodiscard]] static std::vector<std::string> labels() {
        std::vector<std::string> result;
        for (std::size_t i = 0; i < kFamilies * kMembers; ++i) {
            result.push_back(std::to_string(i / kMembers));
        }
        return result;
    }

private:
    static std::vector<descriptor::ModelDescriptor>* models_;
};
std::vector<descriptor::ModelDescriptor>* Ranker::models_ = nullptr;

std::vector<RankOptions> every_option() {
    std::vector<RankOptions> options;
    for (const RankerKind ranker : kAllRankers) {
        for (const bool rerank : {false, true}) {
            options.push_back({.ranker = ranker, .rerank = rerank});
        }
    }
    return options;
}

std::string describe_option(const RankOptions& options) {
    return std::string(to_string(options.ranker)) + (options.rerank ? " re-ranked" : "");
}

std::vector<std::size_t> order_of(const std::vector<double>& distances) {
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
    return order;
}

TEST_F(Ranker, NamesEveryRankerAndReadsItsName) {
    for (const RankerKind ranker : kAllRankers) {
        const auto parsed = parse_ranker(to_string(ranker));
        ASSERT_TRUE(parsed.ok());
        EXPECT_EQ(*parsed, ranker);
    }
    EXPECT_EQ(to_string(RankerKind::kChainCode), "chain-code");
    for (const char* wrong : {"", "Hybrid", "chain_code", "hybrid "}) {
        const auto parsed = parse_ranker(wrong);
        ASSERT_FALSE(parsed.ok()) << wrong;
        EXPECT_EQ(parsed.error().code, ErrorCode::kInvalidArgument);
    }
}

TEST_F(Ranker, PutsEachModelAtDistanceZeroFromItself) {
    const auto all = collection();
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const RankOptions& options : every_option()) {
        for (std::size_t i = 0; i < all.size(); i += 5) {
            const auto distances = *rank_distances(*all[i], all, statistics, options);
            EXPECT_EQ(distances[i], 0.0) << describe_option(options);
            EXPECT_EQ(order_of(distances).front(), i) << describe_option(options);
        }
        const DistanceMatrix matrix = *distance_matrix(all, statistics, options);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(matrix.at(i, i), 0.0F) << describe_option(options);
        }
    }
}

TEST_F(Ranker, FindsTheFamily) {
    const auto all = collection();
    const CollectionStatistics statistics = *collection_statistics(all);
    const double chance = (kMembers - 1.0) / (kFamilies * kMembers - 1.0);
    for (const RankOptions& options : every_option()) {
        const RetrievalReport report =
            evaluate_retrieval(*distance_matrix(all, statistics, options), labels());
        const double wanted = options.ranker == RankerKind::kChainCode ? 2.5 * chance : 0.8;
        EXPECT_GE(report.mean.nearest_neighbor, wanted) << describe_option(options);
        EXPECT_GE(report.mean.first_tier, options.ranker == RankerKind::kChainCode ? chance : 0.6)
            << describe_option(options);
    }
}

TEST_F(Ranker, IsSymmetricBitByBit) {
    const auto all = collection();
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const RankerKind ranker : kAllRankers) {
        const DistanceMatrix matrix = *distance_matrix(all, statistics, {.ranker = ranker});
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                ASSERT_EQ(matrix.at(i, j), matrix.at(j, i)) << to_string(ranker);
            }
        }
        const auto row = *rank_distances(*all[3], all, statistics, {.ranker = ranker});
        const auto other = *rank_distances(*all[9], all, statistics, {.ranker = ranker});
        EXPECT_EQ(row[9], other[3]) << to_string(ranker);
    }
}

TEST_F(Ranker, GivesTheSameBitsForEveryNumberOfJobs) {
    const auto all = collection();
    EXPECT_EQ(collection_statistics(all, 1)->values, collection_statistics(all, 3)->values);
    const CollectionStatistics statistics = *collection_statistics(all);
    const descriptor::ModelDescriptor stranger = test::built_model(77, 1);
    for (RankOptions options : every_option()) {
        const auto one = *rank_distances(stranger, all, statistics, options);
        const auto one_matrix = *distance_matrix(all, statistics, options);
        options.jobs = 3;
        EXPECT_EQ(*rank_distances(stranger, all, statistics, options), one)
            << describe_option(options);
        EXPECT_EQ(distance_matrix(all, statistics, options)->values, one_matrix.values)
            << describe_option(options);
    }
}

TEST_F(Ranker, GivesTheRowsOfItsMatrix) {
    const auto all = collection();
    const std::vector<const descriptor::ModelDescriptor*> half(all.begin(), all.begin() + 10);
    // Statistics of the collection, of a larger one, of another one, and none at all.
    const CollectionStatistics of_all = *collection_statistics(all);
    const CollectionStatistics of_half = *collection_statistics(half);
    for (const RankOptions& options : every_option()) {
        for (const CollectionStatistics& statistics : {of_half, of_all, CollectionStatistics{}}) {
            const DistanceMatrix matrix = *distance_matrix(half, statistics, options);
            for (std::size_t i = 0; i < half.size(); i += 3) {
                const auto row = *rank_distances(*half[i], half, statistics, options);
                for (std::size_t j = 0; j < half.size(); ++j) {
                    ASSERT_EQ(matrix.at(i, j), static_cast<float>(row[j]))
                        << describe_option(options) << " " << i << " " << j;
                }
            }
        }
    }
    const DistanceMatrix unknown = *distance_matrix(all, of_half, {});
    const auto row = *rank_distances(*all[20], all, of_half, {});
    for (std::size_t j = 0; j < all.size(); ++j) {
        EXPECT_EQ(unknown.at(20, j), static_cast<float>(row[j]));
    }
}

TEST_F(Ranker, RanksAQueryFromOutsideLikeOneFromInside) {
    // A copy under the statistics that know it, and under those of the collection without it.
    const auto all = collection();
    std::vector<const descriptor::ModelDescriptor*> others(all.begin() + 1, all.end());
    const CollectionStatistics with = *collection_statistics(all);
    const CollectionStatistics without = *collection_statistics(others);
    const auto inside = order_of(*rank_distances(*all[0], others, with, {}));
    const auto outside = order_of(*rank_distances(*all[0], others, without, {}));
    // The scales differ by one model in 24, so the head of the list may not.
    EXPECT_EQ(std::vector<std::size_t>(inside.begin(), inside.begin() + 3),
              std::vector<std::size_t>(outside.begin(), outside.begin() + 3));
}

TEST_F(Ranker, CopesWithCollectionsOfNoneOneAndTwo) {
    const auto all = collection();
    for (const std::size_t size : {0U, 1U, 2U}) {
        const std::vector<const descriptor::ModelDescriptor*> few(
            all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size));
        const CollectionStatistics statistics = *collection_statistics(few);
        for (const double value : statistics.values) EXPECT_TRUE(std::isfinite(value));
        for (const RankOptions& options : every_option()) {
            const auto distances = *rank_distances(*all[5], few, statistics, options);
            ASSERT_EQ(distances.size(), size);
            for (const double d : distances) {
                EXPECT_TRUE(std::isfinite(d));
                EXPECT_GT(d, 0.0);
            }
            EXPECT_EQ(distance_matrix(few, statistics, options)->values.size(), size * size);
        }
    }
}

TEST_F(Ranker, TakesStatisticsItCannotReadAsNone) {
    const auto all = collection();
    const auto none = *rank_distances(*all[0], all, {}, {});
    const auto foreign = *rank_distances(*all[0], all, {{99.0, 1.0, 2.0}}, {});
    const auto cut = [&] {
        CollectionStatistics statistics = *collection_statistics(all);
        statistics.values.pop_back();
        return *rank_distances(*all[0], all, statistics, {});
    }();
    EXPECT_EQ(none, foreign);
    EXPECT_EQ(none, cut);
}

TEST_F(Ranker, CopesWithADegenerateModel) {
    // A model without a skeleton and with globals of nothing, as a point would have.
    descriptor::ModelDescriptor empty;
    for (const auto& global : models().front().globals) {
        empty.globals.push_back({global.name, std::vector<std::uint8_t>(global.values.size(), 0)});
    }
    empty.signature.assign(models().front().signature.size(), 0.0F);
    std::vector<const descriptor::ModelDescriptor*> all = collection();
    all.push_back(&empty);
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const RankOptions& options : every_option()) {
        const auto distances = *rank_distances(empty, all, statistics, options);
        for (const double d : distances) {
            EXPECT_TRUE(std::isfinite(d)) << describe_option(options);
        }
    }
}

TEST_F(Ranker, ExplainsTheDistanceThatItRanksBy) {
    const auto all = collection();
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const RankerKind ranker : kAllRankers) {
        const RankOptions options{.ranker = ranker};
        const auto distances = *rank_distances(*all[2], all, statistics, options);
        const matching::Match match =
            *explain(*all[2], *all[7], Normalization(statistics), options);
        EXPECT_EQ(match.distance, distances[7]) << to_string(ranker);
        EXPECT_FALSE(match.parts.empty());
        if (ranker != RankerKind::kChainCode) {
            double sum = 0.0;
            for (const matching::DistancePart& part : match.parts) {
                EXPECT_GE(part.value, 0.0);
                sum += part.value;
            }
            EXPECT_NEAR(sum, match.distance, 1e-12);
            const matching::Match plain = *explain(*all[2], *all[7], Normalization(statistics),
                                                   {.ranker = RankerKind::kSkeleton});
            EXPECT_EQ(match.correspondence.nodes.size(), plain.correspondence.nodes.size());
        }
    }
}

TEST_F(Ranker, ChainCodesNeedNoStatistics) {
    const auto all = collection();
    const RankOptions options{.ranker = RankerKind::kChainCode};
    EXPECT_EQ(*rank_distances(*all[4], all, *collection_statistics(all), options),
              *rank_distances(*all[4], all, {}, options));
}

TEST_F(Ranker, MeasuresBuildAloneWithoutPose) {
    // A model bent at its joints is nearer by build than by pose.
    const auto all = collection();
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        const auto build =
            *rank_distances(*all[1], all, statistics, {.ranker = ranker, .pose = 0.0});
        const auto pose =
            *rank_distances(*all[1], all, statistics, {.ranker = ranker, .pose = 1.0});
        EXPECT_EQ(build[1], 0.0);
        EXPECT_EQ(pose[1], 0.0);
        EXPECT_NE(build, pose);
    }
}

TEST_F(Ranker, IsSymmetricBitByBitAndExplainsItselfWherePoseDecides) {
    const auto models = test::built_collection(3, 3);
    const auto collection = test::pointers(models);
    const CollectionStatistics statistics = *collection_statistics(collection);
    for (const RankerKind ranker : {RankerKind::kSkeleton, RankerKind::kHybrid}) {
        RankOptions options;
        options.ranker = ranker;
        options.pose = 1.0;
        const DistanceMatrix matrix = *distance_matrix(collection, statistics, options);
        for (std::size_t i = 0; i < models.size(); ++i) {
            const auto row = *rank_distances(models[i], collection, statistics, options);
            EXPECT_EQ(matrix.at(i, i), 0.0F);
            for (std::size_t j = 0; j < models.size(); ++j) {
                EXPECT_EQ(matrix.at(i, j), matrix.at(j, i));
                EXPECT_EQ(matrix.at(i, j), static_cast<float>(row[j]));
                const matching::Match match =
                    *explain(models[i], models[j], Normalization(statistics), options);
                EXPECT_NEAR(match.distance, row[j], 1e-9);
                double sum = 0.0;
                for (const matching::DistancePart& part : match.parts) sum += part.value;
                EXPECT_NEAR(sum, match.distance, 1e-6);
            }
        }
    }
}

TEST_F(Ranker, LooksForPartsAlikeForEveryNumberOfJobs) {
    const auto models = test::built_collection(3, 3);
    const auto collection = test::pointers(models);
    RankOptions options;
    options.part = true;
    const auto alone = *rank_distances(models[4], collection, {}, options);
    options.jobs = 3;
    EXPECT_EQ(*rank_distances(models[4], collection, {}, options), alone);
    EXPECT_NEAR(alone[4], 0.0, 1e-5);
    for (std::size_t j = 0; j < models.size(); ++j) {
        EXPECT_EQ(explain(models[4], models[j], Normalization(), options)->distance, alone[j]);
    }
}

}  // namespace
}  // namespace ossuary::ranking
