#include "engine/matching/resample.h"

#include <gtest/gtest.h>

namespace ossuary::matching {
namespace {

TEST(Resample, SpacesPointsEvenlyAndKeepsBothEnds) {
    const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {4, 5, 0}};
    const std::vector<double> radii = {1, 2, 5, 10};
    const ResampledCurve curve = resample(points, radii, 1.0, 100);
    EXPECT_DOUBLE_EQ(curve.length, 9.0);
    ASSERT_EQ(curve.points.size(), 10U);
    EXPECT_EQ(curve.points.front(), Vec3f(0, 0, 0));
    EXPECT_EQ(curve.points.back(), Vec3f(4, 5, 0));
    EXPECT_NEAR((curve.points[6] - Vec3f(4, 2, 0)).norm(), 0.0F, 1e-6F);
    EXPECT_NEAR(curve.radii[6], 7.0F, 1e-6F);
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        EXPECT_NEAR((curve.points[i] - curve.points[i - 1]).norm(), 1.0F, 1e-5F);
    }
}

TEST(Resample, GivesTwoPointsForWhatIsShorterThanAStep) {
    const std::vector<Vec3> points = {{2, 2, 2}, {2, 2, 2.1}};
    EXPECT_EQ(resample(points, std::vector<double>{1, 1}, 1.0, 100).points.size(), 2U);
    EXPECT_EQ(resample(std::vector<Vec3>{{1, 2, 3}}, std::vector<double>{4}, 1.0, 100).radii,
              (std::vector<float>{4, 4}));
}

TEST(Resample, LengthensTheStepOfVeryLongCurves) {
    const std::vector<Vec3> points = {{0, 0, 0}, {1000, 0, 0}};
    EXPECT_EQ(resample(points, std::vector<double>{1, 1}, 1.0, 33).points.size(), 33U);
}

TEST(ResamplePart, GivesTheWholeCurveBackEitherWay) {
    const std::vector<float> xyz = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
    const std::vector<float> radii = {1, 2, 3, 4};
    const ResampledCurve forward = resample_part(xyz, radii, 0.0, 1.0, 96);
    const ResampledCurve backward = resample_part(xyz, radii, 1.0, 0.0, 96);
    EXPECT_EQ(forward.radii, radii);
    EXPECT_EQ(backward.radii, (std::vector<float>{4, 3, 2, 1}));
    EXPECT_EQ(backward.points.front(), Vec3f(3, 0, 0));
}

TEST(ResamplePart, CutsAtTheShareOfTheLength) {
    const std::vector<float> xyz = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0};
    const std::vector<float> radii = {1, 1, 1, 1, 1};
    const ResampledCurve part = resample_part(xyz, radii, 1.0, 0.375, 96);
    EXPECT_EQ(part.points.front(), Vec3f(4, 0, 0));
    EXPECT_NEAR(part.points.back().x(), 1.5F, 1e-6F);
    EXPECT_NEAR(part.length, 2.5, 1e-6);
}

}  // namespace
}  // namespace ossuary::matching
