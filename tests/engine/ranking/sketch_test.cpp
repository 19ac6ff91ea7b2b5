#include "engine/ranking/sketch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/ranking/normalization.h"
#include "engine/ranking/scan_rows.h"
#include "tests/engine/ranking/built_models.h"

namespace ossuary::ranking {
namespace {

std::vector<RankOptions> all_options() {
    return {{}, {.ranker = RankerKind::kSkeleton}, {.pose = 0.0}, {.pose = 0.1}, {.size = 1.0}};
}

TEST(Sketch, IsNearestToItselfAndTheSameBothWays) {
    const auto models = test::built_collection(4, 2);
    std::vector<Sketch> sketches;
    for (const auto& model : models) sketches.push_back(sketch_of(model.globals));
    for (const RankOptions& options : all_options()) {
        for (const Sketch& a : sketches) {
            EXPECT_EQ(sketch_components(a, a, options), ComponentValues{});
            for (const Sketch& b : sketches) {
                EXPECT_EQ(sketch_components(a, b, options), sketch_components(b, a, options));
            }
        }
    }
}

TEST(Sketch, KnowsOfEachDescriptorThatTheCheapStagesCompare) {
    const descriptor::ModelDescriptor model = test::built_model(1, 1);
    const Sketch whole = sketch_of(model.globals);
    for (std::size_t place = 0; place < model.globals.size(); ++place) {
        auto globals = model.globals;
        for (std::uint8_t& value : globals[place].values) value = value > 100 ? 0 : 200;
        EXPECT_EQ(sketch_of(globals) != whole, place != descriptor::kPosePointsPlace)
            << globals[place].name;
        globals[place].values.pop_back();
        EXPECT_NO_FATAL_FAILURE((void)sketch_of(globals)) << "of another version";
    }
    EXPECT_EQ(sketch_of({}), Sketch{});
}

TEST(Sketch, IsAboutAsFarAsTheDescriptorsThatItStandsFor) {
    const auto models = test::built_collection(10, 2);
    for (const RankOptions& options : all_options()) {
        ComponentValues about{}, whole{};
        const PairMeter meter(options);
        for (const auto& a : models) {
            for (const auto& b : models) {
                const auto sketched =
                    sketch_components(sketch_of(a.globals), sketch_of(b.globals), options);
                const auto measured = meter.cheap_components(a, b);
                for (std::size_t c = 0; c < kComponentCount; ++c) {
                    about[c] += sketched[c];
                    whole[c] += measured[c];
                }
            }
        }
        for (std::size_t c = 0; c < kComponentCount; ++c) {
            if (c == kBuildComponent && options.pose >= kDefaultPose) continue;  // of no weight
            EXPECT_GE(about[c], 0.6 * whole[c]) << component_name(c);
            EXPECT_LE(about[c], 1.6 * whole[c]) << component_name(c);
        }
    }
}

TEST(ScanRows, HaveWhatTheyWereGiven) {
    const auto models = test::built_collection(2, 2);
    ScanRows rows, joined;
    for (const auto& model : models) rows.append(model);
    joined.append(rows.row(2));
    joined.append(rows);
    ASSERT_EQ(joined.size(), 5U);
    for (const std::size_t at : {0U, 3U}) {
        const ScanRow row = joined.row(at);
        EXPECT_EQ(row.key, model_key(models[2]));
        EXPECT_TRUE(std::ranges::equal(row.signature, signature_bytes(models[2].signature)));
        EXPECT_TRUE(std::ranges::equal(row.sketch, sketch_of(models[2].globals)));
    }
}

}  // namespace
}  // namespace ossuary::ranking
