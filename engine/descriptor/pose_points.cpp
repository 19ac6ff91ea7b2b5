#include "engine/descriptor/pose_points.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace ossuary::descriptor {
namespace {

constexpr double kUnit = 1.0 / 4096.0;
constexpr double kTurning = 0.1;
constexpr double kMirroring = 0.05;
/// Of the 24 ways of laying the axes, and of the 24 mirrored ones, the best by the first points.
constexpr std::size_t kStarts = 3;
constexpr Eigen::Index kFirstPoints = 24;
constexpr int kRounds = 5;
/// Of moving points to the middles of their patches (Lloyd, "Least squares quantization in PCM",
/// 1982), which makes the choice of the first ones matter less.
constexpr int kMiddleRounds = 4;
/// A start that is so much worse than the best after so many rounds is not worth the rest.
constexpr int kRoundsOfGrace = 2;
constexpr float kHopeless = 1.15F;

constexpr auto kCount = static_cast<Eigen::Index>(kPosePoints);
using Mat3f = Eigen::Matrix3f;
using Row = Eigen::Array<float, kCount, 1>;

struct Cloud {
    Row x, y, z;

    [[nodiscard]] Vec3f point(Eigen::Index i) const { return {x[i], y[i], z[i]}; }
};

/// An orthogonal map, then a shift.
struct Placement {
    Mat3f rotation = Mat3f::Identity();
    Vec3f shift = Vec3f::Zero();
};

std::vector<Vec3> farthest_points(const ShellGraph& graph, const Vec3& centre) {
    std::vector<float> distance(graph.size(), std::numeric_limits<float>::infinity());
    std::vector<Vec3> picked;
    Vec3f last = centre.cast<float>();
    while (picked.size() < std::min(kPosePoints, graph.size())) {
        std::size_t next = 0;
        for (std::size_t i = 0; i < graph.size(); ++i) {
            distance[i] = std::min(distance[i], (graph.points[i] - last).squaredNorm());
            if (distance[i] > distance[next]) next = i;
        }
        if (picked.empty()) std::fill(distance.begin(), distance.end(), distance[next]);
        last = graph.points[next];
        picked.emplace_back(last.cast<double>());
    }
    return picked;
}

/// The middle of what of the surface is nearest to each of the points.
std::vector<Vec3> patch_middles(const ShellGraph& graph, const std::vector<Vec3>& points) {
    std::vector<Vec3> sum(points.size(), Vec3::Zero());
    std::vector<double> area(points.size(), 0.0);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Vec3 place = graph.points[i].cast<double>();
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double distance = (place - points[k]).squaredNorm();
            if (distance < least) least = distance, nearest = k;
        }
        const auto weight = static_cast<double>(graph.areas[i]);
        sum[nearest] += weight * place;
        area[nearest] += weight;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        sum[k] = area[k] > 0.0 ? Vec3(sum[k] / area[k]) : points[k];
    }
    return sum;
}

Vec3 centre_of(const ShellGraph& graph) {
    Vec3 centre = Vec3::Zero();
    for (std::size_t i = 0; i < graph.size(); ++i) {
        centre += static_cast<double>(graph.areas[i]) * graph.points[i].cast<double>();
    }
    return graph.total_area > 0.0 ? Vec3(centre / graph.total_area) : centre;
}

Cloud decode(std::span<const std::uint8_t> bytes) {
    Cloud cloud;
    const auto number = [&](std::size_t at) {
        const auto bits = static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
        return static_cast<float>(kUnit) * static_cast<float>(static_cast<std::int16_t>(bits));
    };
    for (Eigen::Index i = 0; i < kCount; ++i) {
        const auto at = 6 * static_cast<std::size_t>(i);
        cloud.x[i] = number(at);
        cloud.y[i] = number(at + 2);
        cloud.z[i] = number(at + 4);
    }
    return cloud;
}

Cloud moved(const Cloud& cloud, const Placement& placement) {
    const Mat3f& r = placement.rotation;
    const Vec3f& t = placement.shift;
    return {r(0, 0) * cloud.x + r(0, 1) * cloud.y + r(0, 2) * cloud.z + t.x(),
            r(1, 0) * cloud.x + r(1, 1) * cloud.y + r(1, 2) * cloud.z + t.y(),
            r(2, 0) * cloud.x + r(2, 1) * cloud.y + r(2, 2) * cloud.z + t.z()};
}

/// The squared distances of one point to the cloud's.
Row squares(const Cloud& cloud, const Vec3f& p) {
    return (cloud.x - p.x()).square() + (cloud.y - p.y()).square() + (cloud.z - p.z()).square();
}

/// The sum of the first points' squared distances to the nearest of the others, both ways.
float rough_distance(const Cloud& a, const Cloud& b) {
    using Few = Eigen::Array<float, kFirstPoints, 1>;
    const Few x = b.x.head<kFirstPoints>(), y = b.y.head<kFirstPoints>(),
              z = b.z.head<kFirstPoints>();
    Few back = Few::Constant(std::numeric_limits<float>::infinity());
    float sum = 0.0F;
    for (Eigen::Index i = 0; i < kFirstPoints; ++i) {
        const Few square = (x - a.x[i]).square() + (y - a.y[i]).square() + (z - a.z[i]).square();
        sum += square.minCoeff();
        back = back.min(square);
    }
    return sum + back.sum();
}

/// Where each point of one cloud has its nearest in the other.
struct Nearest {
    std::array<Eigen::Index, kPosePoints> partner;  ///< of each point of the first
    float mean_distance = 0.0F;                     ///< both ways
};

Nearest nearest(const Cloud& a, const Cloud& b) {
    Nearest result;
    Row back = Row::Constant(std::numeric_limits<float>::infinity());
    float sum = 0.0F;
    for (Eigen::Index i = 0; i < kCount; ++i) {
        const Row square = squares(b, a.point(i));
        const float least = square.minCoeff();
        back = back.min(square);
        Eigen::Index partner = 0;
        while (partner + 1 < kCount && square[partner] > least) ++partner;
        result.partner[static_cast<std::size_t>(i)] = partner;
        sum += std::sqrt(least);
    }
    result.mean_distance = 0.5F * (sum + back.sqrt().sum()) / static_cast<float>(kCount);
    return result;
}

/// How `a` is best laid over its partners in `b`, mirrored or not.
Placement laid_over(const Cloud& a, const Cloud& b, const Nearest& nearest, bool mirrored) {
    Vec3f mean_a = Vec3f::Zero(), mean_b = Vec3f::Zero();
    Mat3f product = Mat3f::Zero();
    for (Eigen::Index i = 0; i < kCount; ++i) {
        const Vec3f from = a.point(i), to = b.point(nearest.partner[static_cast<std::size_t>(i)]);
        mean_a += from;
        mean_b += to;
        product += to * from.transpose();
    }
    constexpr float kShare = 1.0F / static_cast<float>(kCount);
    mean_a *= kShare;
    mean_b *= kShare;
    const Mat3f covariance = kShare * product - mean_b * mean_a.transpose();
    const Eigen::JacobiSVD<Mat3f> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const bool mirrors = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0F;
    const Vec3f signs(1.0F, 1.0F, mirrors == mirrored ? 1.0F : -1.0F);
    Placement placement;
    placement.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    placement.shift = mean_b - placement.rotation * mean_a;
    return placement;
}

/// What lying so adds to a distance, as a factor.
float price(const Mat3f& rotation) {
    const bool mirrors = rotation.determinant() < 0.0F;
    // The trace is that of the turn about an axis, or about the mirror's normal.
    const float cosine = 0.5F * (rotation.trace() + (mirrors ? 1.0F : -1.0F));
    const float turned = 0.5F * (1.0F - std::clamp(cosine, -1.0F, 1.0F));
    return 1.0F + static_cast<float>(kTurning) * turned +
           (mirrors ? static_cast<float>(kMirroring) : 0.0F);
}

/// The least of `best` and of what laying the clouds over each other from `placement` on gives.
float settled_distance(const Cloud& a, const Cloud& b, Placement placement, float best) {
    const bool mirrored = placement.rotation.determinant() < 0.0F;
    for (int round = 0; round <= kRounds; ++round) {
        const Nearest now = nearest(moved(a, placement), b);
        const float distance = price(placement.rotation) * now.mean_distance;
        best = std::min(best, distance);
        if (round == kRoundsOfGrace && distance > kHopeless * best) break;
        placement = laid_over(a, b, now, mirrored);
    }
    return best;
}

Mat3f principal_axes(const Cloud& cloud) {
    const auto product = [](const Row& p, const Row& q) { return (p * q).sum(); };
    const float xy = product(cloud.x, cloud.y), xz = product(cloud.x, cloud.z),
                yz = product(cloud.y, cloud.z);
    Mat3f covariance;
    covariance << product(cloud.x, cloud.x), xy, xz, xy, product(cloud.y, cloud.y), yz, xz, yz,
        product(cloud.z, cloud.z);
    Eigen::SelfAdjointEigenSolver<Mat3f> solver;
    solver.computeDirect(covariance);
    return solver.eigenvectors();
}

struct Start {
    float distance = 0.0F;
    Mat3f rotation;
};

/// The ways of laying principal axes over each other, the promising first.
std::vector<Start> starts(const Cloud& a, const Cloud& b) {
    const Mat3f axes_a = principal_axes(a), axes_b = principal_axes(b);
    std::vector<Start> result;
    std::array<Eigen::Index, 3> order = {0, 1, 2};
    do {
        for (unsigned signs = 0; signs < 8; ++signs) {
            Mat3f exchange = Mat3f::Zero();
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const bool negative = ((signs >> axis) & 1U) != 0;
                exchange(axis, order[static_cast<std::size_t>(axis)]) = negative ? -1.0F : 1.0F;
            }
            const Mat3f rotation = axes_b * exchange * axes_a.transpose();
            result.push_back({rough_distance(moved(a, {rotation, Vec3f::Zero()}), b), rotation});
        }
    } while (std::next_permutation(order.begin(), order.end()));
    std::stable_sort(result.begin(), result.end(), [](const Start& one, const Start& other) {
        return one.distance < other.distance;
    });
    return result;
}

}  // namespace

std::vector<std::uint8_t> pose_points(const ShellGraph& graph, double scale, const Mat3& rotation) {
    std::vector<std::uint8_t> bytes(kPosePointsSize, 0);
    if (graph.empty()) return bytes;
    const Vec3 centre = centre_of(graph);
    std::vector<Vec3> middles = farthest_points(graph, centre);
    for (int round = 0; round < kMiddleRounds; ++round) middles = patch_middles(graph, middles);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& point : middles) mean += point;
    mean /= static_cast<double>(middles.size());
    double square = 0.0;
    for (const Vec3& point : middles) square += (point - mean).squaredNorm();
    const double spread = std::sqrt(square / static_cast<double>(middles.size()));
    const double size = std::sqrt(spread * scale);
    for (std::size_t i = 0; i < kPosePoints; ++i) {
        const Vec3 offset = rotation * (middles[i % middles.size()] - mean);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double units =
                size > 0.0 ? offset[static_cast<Eigen::Index>(axis)] / (size * kUnit) : 0.0;
            const auto number =
                static_cast<std::int16_t>(std::lround(std::clamp(units, -32767.0, 32767.0)));
            const auto bits = static_cast<std::uint16_t>(number);
            bytes[6 * i + 2 * axis] = static_cast<std::uint8_t>(bits & 0xFFU);
            bytes[6 * i + 2 * axis + 1] = static_cast<std::uint8_t>(bits >> 8);
        }
    }
    return bytes;
}

double pose_points_distance(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    assert(a.size() == kPosePointsSize && b.size() == kPosePointsSize);
    const bool swapped = std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end());
    const Cloud first = decode(swapped ? b : a), second = decode(swapped ? a : b);
    float best = settled_distance(first, second, {}, std::numeric_limits<float>::infinity());
    std::array<std::size_t, 2> tried{};
    for (const Start& start : starts(first, second)) {
        std::size_t& count = tried[start.rotation.determinant() < 0.0F ? 1 : 0];
        if (count++ >= kStarts) continue;
        best = settled_distance(first, second, {start.rotation, Vec3f::Zero()}, best);
    }
    return static_cast<double>(best);
}

}  // namespace ossuary::descriptor
