#include "engine/chain_code/five_element_code.h"

#include <gtest/gtest.h>

#include <random>

namespace ossuary::chain_code {
namespace {

const Vec3i kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

std::vector<Vec3i> walk(std::initializer_list<Vec3i> steps, const Vec3i& start = Vec3i::Zero()) {
    std::vector<Vec3i> path = {start};
    for (const Vec3i& step : steps) path.push_back(path.back() + step);
    return path;
}

std::vector<Eigen::Matrix3i> lattice_rotations() {
    std::vector<Eigen::Matrix3i> rotations;
    const Vec3i axes[] = {kX, -kX, kY, -kY, kZ, -kZ};
    for (const Vec3i& x : axes) {
        for (const Vec3i& y : axes) {
            if (x.dot(y) != 0) continue;
            Eigen::Matrix3i rotation;
            rotation << x, y, x.cross(y);
            rotations.push_back(rotation);
        }
    }
    return rotations;
}

std::string random_words(std::mt19937& random, int length) {
    std::string code;
    bool turned = false;
    for (int i = 0; i < length; ++i) {
        // The first turn is always written 4.
        const int value = turned ? std::uniform_int_distribution<>(0, 4)(random)
                                 : 4 * std::uniform_int_distribution<>(0, 1)(random);
        turned = turned || value != 0;
        code.push_back(static_cast<char>('0' + value));
    }
    return code;
}

TEST(ChainElement, FollowsEquation35) {
    // b = x, c = y, so b x c = z.
    EXPECT_EQ(chain_element(kX, kY, kY), '0');
    EXPECT_EQ(chain_element(kX, kY, kZ), '1');
    EXPECT_EQ(chain_element(kX, kY, kX), '2');
    EXPECT_EQ(chain_element(kX, kY, -kZ), '3');
    EXPECT_EQ(chain_element(kX, kY, -kX), '4');
}

TEST(ChainElement, HasOneValueForTheFirstTurn) {
    for (const Vec3i& d : {kX, Vec3i(-kX), kZ, Vec3i(-kZ)}) {
        EXPECT_EQ(chain_element(Vec3i::Zero(), kY, d), '4');
    }
}

TEST(FiveElementCode, IsEmptyWithoutASecondStep) {
    EXPECT_EQ(five_element_code(walk({})), "");
    EXPECT_EQ(five_element_code(walk({kX})), "");
}

TEST(FiveElementCode, WritesAStraightPathAsZeros) {
    EXPECT_EQ(five_element_code(walk({kZ, kZ, kZ, kZ})), "000");
}

TEST(FiveElementCode, WritesAZigzagAsTwos) {
    EXPECT_EQ(five_element_code(walk({kX, kY, kX, kY, kX})), "4222");
}

TEST(FiveElementCode, WritesASquareAsFours) {
    EXPECT_EQ(five_element_code(walk({kX, kY, -kX, -kY})), "444");
}

TEST(FiveElementCode, RemembersTheTurnBeforeAStraightRun) {
    // After x, y, y the preceding differing directions are still x and y.
    EXPECT_EQ(five_element_code(walk({kX, kX, kY, kY, kX})), "0402");
    EXPECT_EQ(five_element_code(walk({kX, kX, kY, kY, kZ})), "0401");
    EXPECT_EQ(five_element_code(walk({kX, kX, kY, kY, -kZ})), "0403");
    EXPECT_EQ(five_element_code(walk({kX, kX, kY, kY, -kX})), "0404");
}

TEST(FiveElementCode, DecodesToAPathWithTheSameCode) {
    std::mt19937 random(11);
    for (int round = 0; round < 500; ++round) {
        const std::string code = random_words(random, round % 40);
        const auto path = decode_five_element_code(code);
        ASSERT_TRUE(path.ok());
        EXPECT_EQ(path->size(), code.size() + 2);
        EXPECT_EQ(five_element_code(*path), code);
    }
}

TEST(FiveElementCode, DeterminesThePathUpToARotation) {
    std::mt19937 random(12);
    for (int round = 0; round < 50; ++round) {
        const auto path = decode_five_element_code(random_words(random, 30));
        ASSERT_TRUE(path.ok());
        for (const Eigen::Matrix3i& rotation : lattice_rotations()) {
            std::vector<Vec3i> moved;
            for (const Vec3i& p : *path) moved.emplace_back(rotation * p + Vec3i(5, -3, 9));
            const std::string code = five_element_code(moved);
            EXPECT_EQ(code, five_element_code(*path));
            // … and the decoded path is a rotated copy: the same distances between all points.
            const auto again = decode_five_element_code(code);
            ASSERT_TRUE(again.ok());
            for (std::size_t i = 0; i < moved.size(); ++i) {
                EXPECT_EQ((moved[i] - moved[0]).squaredNorm(),
                          ((*again)[i] - (*again)[0]).squaredNorm());
            }
        }
    }
}

TEST(FiveElementCode, TellsAMirroredHelixApart) {
    const auto left = walk({kX, kY, kZ, -kX, -kY, kZ});
    std::vector<Vec3i> right;
    for (const Vec3i& p : left) right.emplace_back(p.x(), p.y(), -p.z());
    EXPECT_NE(five_element_code(left), five_element_code(right));
}

TEST(FiveElementCode, RefusesOtherCharacters) {
    const auto path = decode_five_element_code("0425");
    ASSERT_FALSE(path.ok());
    EXPECT_EQ(path.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(path.error().message.find("position 3"), std::string::npos);
}

}  // namespace
}  // namespace ossuary::chain_code
