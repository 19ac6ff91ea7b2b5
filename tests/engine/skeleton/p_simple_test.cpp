#include "engine/skeleton/p_simple.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/skeleton/deletion_templates.h"

namespace ossuary::skeleton {
namespace {

class NeighborhoodSource {
public:
    explicit NeighborhoodSource(unsigned seed) : random_(seed) {}
    Neighborhood operator()() { return static_cast<Neighborhood>(random_()) & k26Neighbors; }

private:
    std::mt19937 random_;
};

/// Simple for the object without S, for every subset S of the candidates.
bool is_p_simple_by_definition(Neighborhood object, Neighborhood candidates) {
    Neighborhood gone = 0;
    do {
        if (!is_simple_by_definition(object & ~gone)) return false;
        gone = (gone - candidates) & candidates;
    } while (gone != 0);
    return true;
}

TEST(PSimple, AgreesWithTheDefinitionOverAllSubsetsOfTheCandidates) {
    const SimplePointTest& simple_point = SimplePointTest::shared();
    NeighborhoodSource random(7);
    int positive = 0;
    for (int round = 0; round < 300'000; ++round) {
        // Several densities, so that both outcomes are common.
        Neighborhood object = random();
        if (round % 3 == 0) object |= random();
        Neighborhood candidates = object & random() & random();
        if (round % 2 == 0) candidates &= random();
        while (std::popcount(candidates) > 8) candidates &= candidates - 1;
        const bool expected = is_p_simple_by_definition(object, candidates);
        ASSERT_EQ(is_p_simple(simple_point, object, candidates), expected)
            << std::hex << object << " " << candidates;
        positive += expected && candidates != 0;
    }
    EXPECT_GT(positive, 1000);
}

TEST(PSimple, IsPlainSimplicityWithoutOtherCandidates) {
    const SimplePointTest& simple_point = SimplePointTest::shared();
    NeighborhoodSource random(8);
    for (int round = 0; round < 100'000; ++round) {
        const Neighborhood object = random();
        ASSERT_EQ(is_p_simple(simple_point, object, 0), simple_point(object));
    }
}

Neighborhood transformed(Neighborhood object, const std::array<int, 3>& order, int signs) {
    Neighborhood result = 0;
    for_each_bit(object, [&](int bit) {
        const NeighborOffset o = neighbor_offset(bit);
        const std::array<int, 3> from = {o.dx, o.dy, o.dz};
        std::array<int, 3> to{};
        for (std::size_t i = 0; i < 3; ++i) {
            to[i] = from[static_cast<std::size_t>(order[i])] * (signs >> i & 1 ? -1 : 1);
        }
        result |= Neighborhood{1} << neighbor_bit({to[0], to[1], to[2]});
    });
    return result;
}

TEST(DeletionTemplates, AreTheSameInAllOrientations) {
    NeighborhoodSource random(9);
    int matches = 0;
    for (int round = 0; round < 20'000; ++round) {
        const Neighborhood object = random() & random();
        const bool expected = matches_deletion_template(object);
        matches += expected;
        std::array<int, 3> order = {0, 1, 2};
        do {
            for (int signs = 0; signs < 8; ++signs) {
                const Neighborhood turned = transformed(object, order, signs);
                ASSERT_EQ(matches_deletion_template(turned), expected);
                ASSERT_EQ(is_tail(turned), is_tail(object));
            }
        } while (std::next_permutation(order.begin(), order.end()));
    }
    EXPECT_GT(matches, 100);
}

TEST(DeletionTemplates, MatchTheSurfaceOfAHalfSpaceAndNotItsInside) {
    Neighborhood half_space = 0;
    for (int bit = 0; bit < 27; ++bit) {
        if (bit != kCentreBit && neighbor_offset(bit).dz <= 0) {
            half_space |= Neighborhood{1} << bit;
        }
    }
    EXPECT_TRUE(matches_deletion_template(half_space));
    EXPECT_FALSE(matches_deletion_template(k26Neighbors));
}

TEST(DeletionTemplates, TailsAreLineEndsAndTheirNeighbors) {
    EXPECT_TRUE(is_tail(0));
    EXPECT_TRUE(is_tail(Neighborhood{1}));
    EXPECT_TRUE(is_tail(Neighborhood{3})) << "two neighbours that touch";
    EXPECT_FALSE(is_tail(Neighborhood{1} | Neighborhood{1} << 26)) << "the middle of a line";
    EXPECT_FALSE(is_tail(Neighborhood{7}));
}

}  // namespace
}  // namespace ossuary::skeleton
