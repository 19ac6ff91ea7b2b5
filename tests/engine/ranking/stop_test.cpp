#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "engine/ranking/explain.h"
#include "engine/ranking/part_search.h"
#include "engine/ranking/preselection.h"
#include "engine/ranking/ranker.h"
#include "tests/support/random.h"

namespace ossuary::ranking {
namespace {

using descriptor::ModelDescriptor;
using skeleton::SkeletonGraph;
using Clock = std::chrono::steady_clock;

void add_branch(SkeletonGraph& graph, std::uint32_t from, const Vec3& to, std::mt19937_64& random) {
    const auto end = static_cast<std::uint32_t>(graph.nodes.size());
    const double radius = 1.0 + test::next_unit(random);
    graph.nodes.push_back({to, radius, test::next_unit(random), 0});
    SkeletonGraph::Branch branch{from, end, {}, {}};
    for (int i = 0; i <= 6; ++i) {
        branch.points.push_back(graph.nodes[from].position +
                                i / 6.0 * (to - graph.nodes[from].position));
        branch.radii.push_back(radius);
    }
    graph.branches.push_back(std::move(branch));
}

/// A hub with rays, each of which ends in a fork of a few: every matcher works on a pair of these
/// for far longer than a test may.
ModelDescriptor sea_urchin(std::size_t rays, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    SkeletonGraph graph;
    graph.nodes.push_back({Vec3::Zero(), 5.0, 1.0, 0});
    const auto anywhere = [&] {
        return Vec3(test::next_unit(random) - 0.5, test::next_unit(random) - 0.5,
                    test::next_unit(random) - 0.5);
    };
    for (std::size_t i = 0; i < rays; ++i) {
        const Vec3 end = 100.0 * anywhere();
        const auto fork = static_cast<std::uint32_t>(graph.nodes.size());
        add_branch(graph, 0, end, random);
        for (int k = 0; k < 3; ++k) add_branch(graph, fork, end + 20.0 * anywhere(), random);
    }
    update_degrees(graph);
    ModelDescriptor model;
    model.skeleton = matching::describe_skeleton(graph, 100.0);
    return model;
}

class Stop : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        models_ = new std::vector<ModelDescriptor>;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) models_->push_back(sea_urchin(700, seed));
    }
    static void TearDownTestSuite() {
        delete models_;
        models_ = nullptr;
    }
    static const ModelDescriptor& query() { return models_->front(); }
    static std::vector<const ModelDescriptor*> collection(std::size_t times = 1) {
        std::vector<const ModelDescriptor*> all;
        for (std::size_t i = 0; i < times; ++i) {
            for (const ModelDescriptor& model : *models_) all.push_back(&model);
        }
        return all;
    }

    using Work = std::function<ErrorCode(const std::stop_token&)>;
    /// Asks `work` to stop after a while and expects that it does.
    static void expect_to_stop(const Work& work, const std::string& what) {
        std::stop_source source;
        Clock::time_point asked;
        std::thread asker([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            asked = Clock::now();
            source.request_stop();
        });
        const ErrorCode code = work(source.get_token());
        const auto ended = Clock::now();
        asker.join();
        EXPECT_EQ(code, ErrorCode::kCancelled) << what;
        EXPECT_LT(ended - asked, std::chrono::milliseconds(1500)) << what;  // on a busy machine
    }
    template <typename T>
    static ErrorCode code_of(const Result<T>& result) {
        return result ? ErrorCode::kInternal : result.error().code;
    }
    static std::vector<RankOptions> every_option() {
        std::vector<RankOptions> all;
        for (const RankerKind ranker : kAllRankers) all.push_back({.ranker = ranker});
        all.push_back({.ranker = RankerKind::kSkeleton, .pose = 1.0});
        all.push_back({.rerank = true, .jobs = 2});
        all.push_back({.part = true});
        return all;
    }
    static std::string name(const RankOptions& options) {
        return std::string(to_string(options.ranker)) + (options.part ? " part" : "") +
               (options.rerank ? " re-ranked" : "") + " pose " + std::to_string(options.pose);
    }

private:
    static std::vector<ModelDescriptor>* models_;
};
std::vector<ModelDescriptor>* Stop::models_ = nullptr;

TEST_F(Stop, EndsWithinOnePairOfModels) {
    for (RankOptions options : every_option()) {
        // Trees of a limited number of pieces are compared in a moment.
        if (options.ranker != RankerKind::kChainCode && !options.part) continue;
        expect_to_stop(
            [&](const std::stop_token& stop) {
                options.stop = stop;
                return code_of(explain(query(), *collection()[1], Normalization(), options));
            },
            name(options));
    }
}

TEST_F(Stop, EndsARankingAndANearestSearch) {
    const std::vector<const ModelDescriptor*> all = collection(2000);
    DescriptorsInMemory source(all);
    ScanRows rows;
    for (const ModelDescriptor* model : all) rows.append(*model);
    const Preselection preselection({&rows});
    for (RankOptions options : every_option()) {
        expect_to_stop(
            [&](const std::stop_token& stop) {
                options.stop = stop;
                return code_of(rank_distances(query(), all, {}, options));
            },
            name(options));
        expect_to_stop(
            [&](const std::stop_token& stop) {
                options.stop = stop;
                const NearestOptions narrow{.count = 1000, .exhaustive_below = 0, .by_sketch = 10};
                return code_of(nearest_models(query(), source, preselection, Normalization(),
                                              options, narrow));
            },
            name(options) + " nearest");
    }
}

TEST_F(Stop, EndsAMatrixAndStatistics) {
    const std::vector<const ModelDescriptor*> all = collection(100);
    expect_to_stop(
        [&](const std::stop_token& stop) { return code_of(collection_statistics(all, 2, stop)); },
        "statistics");
    for (RankOptions options : every_option()) {
        if (options.part) continue;
        expect_to_stop(
            [&](const std::stop_token& stop) {
                options.stop = stop;
                return code_of(distance_matrix(all, {}, options));
            },
            name(options));
    }
}

TEST_F(Stop, IsAnsweredAtOnceWhereItWasAskedForBefore) {
    std::stop_source source;
    source.request_stop();
    for (RankOptions options : every_option()) {
        options.stop = source.get_token();
        const auto start = Clock::now();
        EXPECT_EQ(code_of(rank_distances(query(), collection(), {}, options)),
                  ErrorCode::kCancelled);
        EXPECT_LT(Clock::now() - start, std::chrono::seconds(1)) << name(options);
    }
}

}  // namespace
}  // namespace ossuary::ranking
