#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/descriptor/pose_points.h"

namespace ossuary::descriptor {
namespace {

constexpr double kTurning = 0.1;
constexpr double kMirroring = 0.05;
/// Of the 24 ways of laying the axes, and of the 24 mirrored ones, the best by the first points.
constexpr std::size_t kStarts = 4;
constexpr Eigen::Index kFirstPoints = 16;
/// The ways are compared by so many points, moved to their nearest so often.
constexpr Eigen::Index kFewPoints = 48;
/// A start that is so much worse than the best after so many rounds is not worth the rest.
constexpr int kRoundsOfGrace = 2;
constexpr float kHopeless = 1.15F;
constexpr int kRounds = 5;

using Mat3f = Eigen::Matrix3f;

/// The first points of a body.
template <Eigen::Index count>
struct Cloud {
    using Row = Eigen::Array<float, count, 1>;
    Row x, y, z;

    [[nodiscard]] Vec3f point(Eigen::Index i) const { return {x[i], y[i], z[i]}; }
    void set_point(Eigen::Index i, const Vec3f& p) { x[i] = p.x(), y[i] = p.y(), z[i] = p.z(); }

    template <Eigen::Index fewer>
    [[nodiscard]] Cloud<fewer> first() const {
        return {x.template head<fewer>(), y.template head<fewer>(), z.template head<fewer>()};
    }

    /// The squared distances of one point to the cloud's.
    [[nodiscard]] Row squares(const Vec3f& p) const {
        return (x - p.x()).square() + (y - p.y()).square() + (z - p.z()).square();
    }
};

using Body = Cloud<static_cast<Eigen::Index>(kPosePoints)>;

/// An orthogonal map, then a shift.
struct Placement {
    Mat3f rotation = Mat3f::Identity();
    Vec3f shift = Vec3f::Zero();

    [[nodiscard]] bool mirrors() const { return rotation.determinant() < 0.0F; }

    template <Eigen::Index count>
    [[nodiscard]] Cloud<count> operator()(const Cloud<count>& cloud) const {
        const Mat3f& r = rotation;
        const Vec3f& t = shift;
        return {r(0, 0) * cloud.x + r(0, 1) * cloud.y + r(0, 2) * cloud.z + t.x(),
                r(1, 0) * cloud.x + r(1, 1) * cloud.y + r(1, 2) * cloud.z + t.y(),
                r(2, 0) * cloud.x + r(2, 1) * cloud.y + r(2, 2) * cloud.z + t.z()};
    }
};

Body decode(std::span<const std::uint8_t> bytes) {
    Body body;
    const auto number = [&](std::size_t at) {
        const auto bits = static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
        return static_cast<float>(kPosePointsUnit) *
               static_cast<float>(static_cast<std::int16_t>(bits));
    };
    for (std::size_t i = 0; i < kPosePoints; ++i) {
        body.set_point(static_cast<Eigen::Index>(i),
                       {number(6 * i), number(6 * i + 2), number(6 * i + 4)});
    }
    return body;
}

/// Where each point of one cloud has its nearest in the other, and the other way round.
template <Eigen::Index count>
struct Nearest {
    std::array<Eigen::Index, static_cast<std::size_t>(count)> partner;  ///< of each of the first
    float mean_distance = 0.0F;                                         ///< both ways
};

/// Replaces the last bits of each distance, which is not negative, by its place in the row: the
/// least then knows where it stood.
template <typename Row>
void mark_places(Row& row) {
    static_assert(Row::SizeAtCompileTime <= 128);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(Row::SizeAtCompileTime); ++i) {
        float& number = row.data()[i];
        number = std::bit_cast<float>((std::bit_cast<std::uint32_t>(number) & ~127U) | i);
    }
}

template <Eigen::Index count>
Nearest<count> nearest(const Cloud<count>& a, const Cloud<count>& b) {
    using Row = typename Cloud<count>::Row;
    Nearest<count> result;
    Row back = Row::Constant(std::numeric_limits<float>::max());
    Row there;
    for (Eigen::Index i = 0; i < count; ++i) {
        Row square = b.squares(a.point(i));
        back = back.min(square);
        mark_places(square);
        there[i] = square.minCoeff();
        result.partner[static_cast<std::size_t>(i)] = std::bit_cast<std::uint32_t>(there[i]) & 127U;
    }
    const float sum = there.sqrt().sum() + back.sqrt().sum();
    result.mean_distance = 0.5F * sum / static_cast<float>(count);
    return result;
}

template <Eigen::Index count>
Cloud<count> partners(const Cloud<count>& cloud, const Nearest<count>& nearest) {
    Cloud<count> result;
    for (Eigen::Index i = 0; i < count; ++i) {
        result.set_point(i, cloud.point(nearest.partner[static_cast<std::size_t>(i)]));
    }
    return result;
}

template <Eigen::Index count>
Mat3f products(const Cloud<count>& a, const Cloud<count>& b) {
    const auto sum = [](const auto& p, const auto& q) { return (p * q).sum(); };
    Mat3f result;
    result << sum(a.x, b.x), sum(a.x, b.y), sum(a.x, b.z), sum(a.y, b.x), sum(a.y, b.y),
        sum(a.y, b.z), sum(a.z, b.x), sum(a.z, b.y), sum(a.z, b.z);
    return result;
}

template <Eigen::Index count>
Vec3f mean(const Cloud<count>& cloud) {
    return {cloud.x.mean(), cloud.y.mean(), cloud.z.mean()};
}

/// How `from` is best laid over the points of `to`, one by one, mirrored or not.
template <Eigen::Index count>
Placement laid_over(const Cloud<count>& from, const Cloud<count>& to, bool mirrored) {
    constexpr float kShare = 1.0F / static_cast<float>(count);
    const Vec3f mean_from = mean(from), mean_to = mean(to);
    const Mat3f covariance = kShare * products(to, from) - mean_to * mean_from.transpose();
    const Eigen::JacobiSVD<Mat3f> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const bool mirrors = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0F;
    const Vec3f signs(1.0F, 1.0F, mirrors == mirrored ? 1.0F : -1.0F);
    Placement placement;
    placement.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    placement.shift = mean_to - placement.rotation * mean_from;
    return placement;
}

/// What lying so adds to a distance, as a factor.
float price(const Placement& placement) {
    const bool mirrors = placement.mirrors();
    // The trace is that of the turn about an axis, or about the mirror's normal.
    const float cosine = 0.5F * (placement.rotation.trace() + (mirrors ? 1.0F : -1.0F));
    const float turned = 0.5F * (1.0F - std::clamp(cosine, -1.0F, 1.0F));
    return 1.0F + static_cast<float>(kTurning) * turned +
           (mirrors ? static_cast<float>(kMirroring) : 0.0F);
}

/// A placement and how far surfaces are apart so.
struct Settled {
    Placement placement;
    float distance = std::numeric_limits<float>::infinity();
};

/// The best of `best`, of `placement`, and of what so many rounds of moving to the nearest points
/// make of it.
template <Eigen::Index count>
Settled settle(const Cloud<count>& a, const Cloud<count>& b, Placement placement, int rounds,
               Settled best = {}) {
    const bool mirrored = placement.mirrors();
    for (int round = 0;; ++round) {
        const Nearest<count> now = nearest(placement(a), b);
        const float distance = price(placement) * now.mean_distance;
        if (distance < best.distance) best = {placement, distance};
        const bool hopeless = round == kRoundsOfGrace && distance > kHopeless * best.distance;
        if (round == rounds || hopeless) return best;
        placement = laid_over(a, partners(b, now), mirrored);
    }
}

Mat3f principal_axes(const Body& body) {
    Eigen::SelfAdjointEigenSolver<Mat3f> solver;
    solver.computeDirect(products(body, body));
    return solver.eigenvectors();
}

/// The sum of the first points' squared distances to the nearest of the others, both ways.
float rough_distance(const Cloud<kFirstPoints>& a, const Cloud<kFirstPoints>& b) {
    using Row = Cloud<kFirstPoints>::Row;
    Row back = Row::Constant(std::numeric_limits<float>::infinity());
    float sum = 0.0F;
    for (Eigen::Index i = 0; i < kFirstPoints; ++i) {
        const Row square = b.squares(a.point(i));
        sum += square.minCoeff();
        back = back.min(square);
    }
    return sum + back.sum();
}

/// The ways of laying principal axes over each other, the promising first.
std::vector<Settled> starts(const Body& a, const Body& b) {
    const Mat3f axes_a = principal_axes(a), axes_b = principal_axes(b);
    const Cloud<kFirstPoints> first_a = a.first<kFirstPoints>(), first_b = b.first<kFirstPoints>();
    std::vector<Settled> result;
    std::array<Eigen::Index, 3> order = {0, 1, 2};
    do {
        for (unsigned signs = 0; signs < 8; ++signs) {
            Mat3f exchange = Mat3f::Zero();
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const bool negative = ((signs >> axis) & 1U) != 0;
                exchange(axis, order[static_cast<std::size_t>(axis)]) = negative ? -1.0F : 1.0F;
            }
            const Placement way{axes_b * exchange * axes_a.transpose(), Vec3f::Zero()};
            result.push_back({way, rough_distance(way(first_a), first_b)});
        }
    } while (std::next_permutation(order.begin(), order.end()));
    std::stable_sort(result.begin(), result.end(), [](const Settled& one, const Settled& other) {
        return one.distance < other.distance;
    });
    return result;
}

/// How `a` lies best over `b`: by a few points first, from all the promising ways.
Settled best_placement(const Body& a, const Body& b) {
    const Cloud<kFewPoints> few_a = a.first<kFewPoints>(), few_b = b.first<kFewPoints>();
    Settled best = settle(few_a, few_b, {}, kRounds);
    std::array<std::size_t, 2> tried{};
    for (const Settled& start : starts(a, b)) {
        std::size_t& count = tried[start.placement.mirrors() ? 1 : 0];
        if (count++ >= kStarts) continue;
        best = settle(few_a, few_b, start.placement, kRounds, best);
    }
    return settle(a, b, best.placement, 3);
}

/// The mean of 1 - cos of the angle between the direction from point to point of one body and from
/// partner to partner on the other, over all pairs, after the turn that makes it least. That turn
/// need not be made: the sum of the cosines is then that of the singular values of the sum of the
/// directions' products.
float direction_difference(const Body& a, const Body& b) {
    Mat3f sum = Mat3f::Zero();
    float pairs = 0.0F;
    const auto count = static_cast<Eigen::Index>(kPosePoints);
    for (Eigen::Index i = 1; i < count; ++i) {
        const auto difference = [i](const Body::Row& row) { return row.head(i) - row[i]; };
        using Some = Eigen::Array<float, Eigen::Dynamic, 1, 0, count, 1>;
        const Some ax = difference(a.x), ay = difference(a.y), az = difference(a.z);
        const Some bx = difference(b.x), by = difference(b.y), bz = difference(b.z);
        const Some square_a = ax.square() + ay.square() + az.square();
        const Some square_b = bx.square() + by.square() + bz.square();
        // Points that fall together have no direction: such pairs agree in nothing.
        constexpr float kLeast = std::numeric_limits<float>::min();
        const Some weight = 1.0F / (square_a.max(kLeast).sqrt() * square_b.max(kLeast).sqrt());
        const Some wx = weight * ax, wy = weight * ay, wz = weight * az;
        Mat3f row;
        row << (bx * wx).sum(), (bx * wy).sum(), (bx * wz).sum(), (by * wx).sum(), (by * wy).sum(),
            (by * wz).sum(), (bz * wx).sum(), (bz * wy).sum(), (bz * wz).sum();
        sum += row;
        pairs += static_cast<float>(i);
    }
    const Eigen::JacobiSVD<Mat3f> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const bool mirrors = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0F;
    const Vec3f values = svd.singularValues();
    const float cosines = values[0] + values[1] + (mirrors ? -values[2] : values[2]);
    return std::max(0.0F, 1.0F - cosines / pairs);
}

}  // namespace

double pose_points_distance(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    assert(a.size() == kPosePointsSize && b.size() == kPosePointsSize);
    if (std::equal(a.begin(), a.end(), b.begin())) return 0.0;
    const bool swapped = std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end());
    const Body first = decode(swapped ? b : a), second = decode(swapped ? a : b);
    const Settled best = best_placement(first, second);
    const Body placed = best.placement(first);
    const float there = direction_difference(placed, partners(second, nearest(placed, second)));
    const float back = direction_difference(second, partners(placed, nearest(second, placed)));
    return static_cast<double>(
        std::sqrt(best.distance * price(best.placement) * 0.5F * (there + back)));
}

}  // namespace ossuary::descriptor
