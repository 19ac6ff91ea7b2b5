#include "engine/descriptor/signature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/descriptor/describe.h"
#include "engine/descriptor/global_descriptors.h"
#include "tests/support/shapes.h"

namespace ossuary::descriptor {
namespace {

double norm(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
    return std::sqrt(sum);
}

double signature_distance(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += d * d;
    }
    return std::sqrt(sum);
}

TEST(Signature, IsOfUnitLengthEvenWithoutASkeleton) {
    const voxel::BitVolume volume = test::ball().volume;
    const auto globals = global_descriptors(solid_surface(volume), volume, {});
    const auto signature = preselection_signature({}, globals);
    ASSERT_EQ(signature.size(), kSignatureSize);
    EXPECT_NEAR(norm(signature), 1.0, 1e-5);

    std::vector<GlobalDescriptor> nothing = globals;
    for (auto& global : nothing) global.values.assign(global.values.size(), 0);
    EXPECT_NEAR(norm(preselection_signature({}, nothing)), 1.0, 1e-5);
}

TEST(Signature, IsNearerForARotatedCopyThanForAnotherShape) {
    const auto tree = describe(test::capsule_tree_mesh());
    const auto turned =
        describe(test::transformed(test::capsule_tree_mesh(), test::random_rotation(4)));
    const auto torus = describe(test::torus_mesh(1.0, 0.3));
    ASSERT_TRUE(tree.ok() && turned.ok() && torus.ok());
    const auto& signature = tree->descriptor.signature;
    EXPECT_NEAR(norm(signature), 1.0, 1e-5);
    EXPECT_LT(2.0 * signature_distance(signature, turned->descriptor.signature),
              signature_distance(signature, torus->descriptor.signature));
}

}  // namespace
}  // namespace ossuary::descriptor
