#include "engine/decomposition/segmentation_metrics.h"

#include <gtest/gtest.h>

#include <random>

namespace ossuary::decomposition {
namespace {

std::vector<double> ones(std::size_t count) { return std::vector<double>(count, 1.0); }

SegmentationErrors errors_of(const std::vector<std::uint32_t>& a,
                             const std::vector<std::uint32_t>& b) {
    return segmentation_errors(dense_segmentation(a), dense_segmentation(b), ones(a.size()));
}

/// By the definition: every pair of faces is looked at.
double rand_index_error_by_pairs(const std::vector<std::uint32_t>& a,
                                 const std::vector<std::uint32_t>& b) {
    std::size_t differing = 0, all = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            ++all;
            if ((a[i] == a[j]) != (b[i] == b[j])) ++differing;
        }
    }
    return static_cast<double>(differing) / static_cast<double>(all);
}

TEST(SegmentationMetrics, AreZeroForTheSamePartsUnderOtherNames) {
    const SegmentationErrors errors = errors_of({0, 0, 1, 2, 2}, {9, 9, 4, 0, 0});
    EXPECT_EQ(errors.rand_index_error, 0.0);
    EXPECT_EQ(errors.hamming, 0.0);
    EXPECT_EQ(errors.global_consistency, 0.0);
    EXPECT_EQ(errors.local_consistency_area, 0.0);
}

TEST(SegmentationMetrics, MatchAHandComputedCase) {
    // Reference {0,1,2} {3,4,5}; segmentation {0,1} {2,3} {4,5}.
    const SegmentationErrors errors = errors_of({0, 0, 0, 1, 1, 1}, {0, 0, 1, 1, 2, 2});
    // Together in the reference 6 pairs, in the segmentation 3, in both 2: (6 + 3 - 4) / 15.
    EXPECT_DOUBLE_EQ(errors.rand_index_error, 5.0 / 15.0);
    // Each reference part is covered by 2 of 3 faces; of the segmentation's, the middle loses 1.
    EXPECT_DOUBLE_EQ(errors.hamming_missing, 2.0 / 6.0);
    EXPECT_DOUBLE_EQ(errors.hamming_false_alarm, 1.0 / 6.0);
    EXPECT_DOUBLE_EQ(errors.hamming, 0.25);
    // From the reference: 1/3 for four faces, 2/3 for two; back: 0 for four, 1/2 for two.
    EXPECT_DOUBLE_EQ(errors.global_consistency, 1.0 / 6.0);
    EXPECT_DOUBLE_EQ(errors.local_consistency, 1.0 / 6.0);
}

TEST(SegmentationMetrics, HammingAndTheAreaVariantsWeighByArea) {
    const Segmentation a = dense_segmentation({0, 0, 1, 1});
    const Segmentation b = dense_segmentation({0, 1, 1, 1});
    const SegmentationErrors errors = segmentation_errors(a, b, {3.0, 1.0, 2.0, 4.0});
    EXPECT_DOUBLE_EQ(errors.hamming_missing, 0.1);
    EXPECT_DOUBLE_EQ(errors.hamming_false_alarm, 0.1);
    // Forth: 1/4 for face 0, 3/4 for face 1, 0 else; back: 0, then 6/7 for face 1, 1/7 for 2 and 3.
    EXPECT_DOUBLE_EQ(errors.global_consistency_area, 0.25);
    EXPECT_DOUBLE_EQ(errors.local_consistency_area, 0.75 / 4.0);
    EXPECT_DOUBLE_EQ(errors.rand_index_error, 0.5);
}

TEST(SegmentationMetrics, ARefinementCostsRandIndexButNoConsistency) {
    const SegmentationErrors errors = errors_of({0, 0, 0, 0, 1, 1}, {0, 0, 1, 1, 2, 2});
    EXPECT_GT(errors.rand_index_error, 0.0);
    EXPECT_EQ(errors.global_consistency, 0.0);
    EXPECT_EQ(errors.local_consistency, 0.0);
}

TEST(SegmentationMetrics, RandIndexErrorIsTheShareOfPairsThatDiffer) {
    std::mt19937 generator(7);
    const auto random = [&] { return static_cast<std::uint32_t>(generator()); };
    for (int round = 0; round < 50; ++round) {
        const std::size_t faces = 2 + random() % 60;
        const std::uint32_t parts_a = 1 + random() % 9, parts_b = 1 + random() % 9;
        std::vector<std::uint32_t> a(faces), b(faces);
        for (std::uint32_t& label : a) label = random() % parts_a;
        for (std::uint32_t& label : b) label = random() % parts_b;
        EXPECT_NEAR(errors_of(a, b).rand_index_error, rand_index_error_by_pairs(a, b), 1e-12);
    }
}

TEST(SegmentationMetrics, SurviveOneFaceAndNoArea) {
    const Segmentation one = dense_segmentation({3});
    const SegmentationErrors errors = segmentation_errors(one, one, {0.0});
    EXPECT_EQ(errors.rand_index_error, 0.0);
    EXPECT_EQ(errors.hamming, 0.0);
}

}  // namespace
}  // namespace ossuary::decomposition
