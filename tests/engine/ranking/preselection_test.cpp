#include "engine/ranking/preselection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "tests/engine/ranking/built_models.h"

namespace ossuary::ranking {
namespace {

/// Ten families of four models; built once for all tests.
class PreselectionTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        models_ = new std::vector<descriptor::ModelDescriptor>(test::built_collection(10, 4));
    }
    static void TearDownTestSuite() {
        delete models_;
        models_ = nullptr;
    }
    static std::vector<const descriptor::ModelDescriptor*> collection() {
        return test::pointers(*models_);
    }

    static std::vector<descriptor::ModelDescriptor>* models_;
};
std::vector<descriptor::ModelDescriptor>* PreselectionTest::models_ = nullptr;

std::vector<std::size_t> indices(const std::vector<RankedModel>& models) {
    std::vector<std::size_t> result;
    for (const RankedModel& model : models) result.push_back(model.index);
    return result;
}

/// A collection with all that a search asks for, its rows in blocks of seven models.
class Scanned {
public:
    explicit Scanned(DescriptorSpan collection) : source_(collection) {
        for (std::size_t i = 0; i < collection.size(); ++i) {
            if (i % 7 == 0) blocks_.push_back(std::make_unique<ScanRows>());
            blocks_.back()->append(*collection[i]);
        }
        std::vector<const ScanRows*> rows;
        for (const auto& block : blocks_) rows.push_back(block.get());
        preselection = Preselection(rows);
    }
    Result<std::vector<RankedModel>> nearest(const descriptor::ModelDescriptor& query,
                                             const CollectionStatistics& statistics,
                                             const RankOptions& options,
                                             const NearestOptions& nearest) {
        return nearest_models(query, source_, preselection, Normalization(statistics), options,
                              nearest);
    }

    Preselection preselection;

private:
    DescriptorsInMemory source_;
    std::vector<std::unique_ptr<ScanRows>> blocks_;
};

/// Stages so narrow that a small collection goes through all of them.
NearestOptions narrow() {
    return {.count = 2, .spare = 0, .exhaustive_below = 10, .by_signature = 30, .by_sketch = 20};
}

TEST_F(PreselectionTest, ScansToTheNearestSignatures) {
    const auto all = collection();
    Scanned scanned(all);
    ASSERT_EQ(scanned.preselection.size(), all.size());
    for (std::size_t i = 0; i < all.size(); i += 7) {
        const auto one = scanned.preselection.nearest(all[i]->signature, 1);
        EXPECT_EQ(one, std::vector<std::uint32_t>{static_cast<std::uint32_t>(i)});
        const auto ten = scanned.preselection.nearest(all[i]->signature, 10);
        EXPECT_EQ(ten.size(), 10U);
        EXPECT_TRUE(std::is_sorted(ten.begin(), ten.end()));
        EXPECT_TRUE(std::find(ten.begin(), ten.end(), i) != ten.end());
    }
    std::vector<std::uint32_t> everything(all.size());
    std::iota(everything.begin(), everything.end(), 0U);
    EXPECT_EQ(scanned.preselection.nearest(all[0]->signature, 1000), everything);
    EXPECT_TRUE(Preselection().nearest(all[0]->signature, 5).empty());
}

TEST_F(PreselectionTest, GivesTheDistancesOfTheFullSearch) {
    const auto all = collection();
    Scanned scanned(all);
    const CollectionStatistics statistics = *collection_statistics(all);
    const descriptor::ModelDescriptor stranger = test::built_model(3, 99);
    for (const RankerKind ranker : kAllRankers) {
        const RankOptions options{.ranker = ranker};
        for (const descriptor::ModelDescriptor* query : {all[5], &stranger}) {
            const auto exact = *rank_distances(*query, all, statistics, options);
            const auto found = *scanned.nearest(*query, statistics, options, narrow());
            ASSERT_EQ(found.size(), 2U);
            for (const RankedModel& model : found) {
                EXPECT_EQ(model.distance, exact[model.index]) << to_string(ranker);
            }
            EXPECT_LE(found[0].distance, found[1].distance);
            EXPECT_EQ(found[0].distance, *std::min_element(exact.begin(), exact.end()))
                << to_string(ranker);
        }
    }
}

TEST_F(PreselectionTest, TakesOnlyWhatItIsToldAtTheSameDistances) {
    const auto all = collection();
    Scanned scanned(all);
    const CollectionStatistics statistics = *collection_statistics(all);
    std::vector<std::uint32_t> odd;
    for (std::uint32_t i = 1; i < all.size(); i += 2) odd.push_back(i);
    for (const RankerKind ranker : kAllRankers) {
        for (const bool rerank : {false, true}) {
            const RankOptions options{.ranker = ranker, .rerank = rerank};
            const auto exact = *rank_distances(*all[4], all, statistics, options);
            NearestOptions nearest = narrow();
            nearest.among = odd;
            const auto found = *scanned.nearest(*all[4], statistics, options, nearest);
            ASSERT_EQ(found.size(), 2U);
            for (const RankedModel& model : found) {
                EXPECT_EQ(model.index % 2, 1U);
                EXPECT_EQ(model.distance, exact[model.index]) << to_string(ranker);
            }
            double least = exact[1];
            for (const std::uint32_t i : odd) least = std::min(least, exact[i]);
            EXPECT_EQ(found[0].distance, least) << to_string(ranker);
            nearest.among = std::span<const std::uint32_t>();
            EXPECT_TRUE(scanned.nearest(*all[4], statistics, options, nearest)->empty());
        }
    }
}

TEST_F(PreselectionTest, HasMoreToSpareWithoutLookingAtEverything) {
    const auto all = collection();
    Scanned scanned(all);
    const CollectionStatistics statistics = *collection_statistics(all);
    NearestOptions nearest = narrow();
    const auto wanted = *scanned.nearest(*all[6], statistics, {}, nearest);
    nearest.spare = all.size();
    const auto more = *scanned.nearest(*all[6], statistics, {}, nearest);
    EXPECT_EQ(more.size(), nearest.by_sketch);
    EXPECT_EQ(indices({more.begin(), more.begin() + 2}), indices(wanted));
    nearest.exhaustive_below = all.size();
    nearest.spare = 3;
    EXPECT_EQ(scanned.nearest(*all[6], statistics, {}, nearest)->size(), 5U);
}

TEST_F(PreselectionTest, MissesNothingInASmallCollection) {
    const auto all = collection();
    Scanned scanned(all);
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const bool rerank : {false, true}) {
        const RankOptions options{.rerank = rerank};
        const auto distances = *rank_distances(*all[9], all, statistics, options);
        const auto found = *scanned.nearest(*all[9], statistics, options, {.count = all.size()});
        ASSERT_EQ(found.size(), all.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].distance, distances[found[i].index]);
            EXPECT_LE(found[i > 0 ? i - 1 : 0].distance, found[i].distance);
        }
    }
}

TEST_F(PreselectionTest, GivesTheSameForEveryNumberOfJobs) {
    const auto all = collection();
    Scanned scanned(all);
    const CollectionStatistics statistics = *collection_statistics(all);
    for (const bool rerank : {false, true}) {
        RankOptions options{.rerank = rerank};
        const auto one = *scanned.nearest(*all[17], statistics, options, narrow());
        options.jobs = 3;
        const auto three = *scanned.nearest(*all[17], statistics, options, narrow());
        EXPECT_EQ(indices(one), indices(three));
        EXPECT_EQ(one.front().index, 17U);
    }
}

}  // namespace
}  // namespace ossuary::ranking
