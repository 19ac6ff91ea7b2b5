#include "engine/registration/axis_candidates.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>

namespace ossuary::registration {
namespace {

constexpr double kAlike = 0.9;    ///< ratio of two moments from which they are alike
constexpr int kStepsOfTurn = 24;  ///< about an axis around which the moments are alike

struct Frame {
    Vec3 center = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  ///< columns, greatest moment first, right-handed
    Vec3 moments = Vec3::Zero();
};

Frame frame_of(const SurfacePoints& surface) {
    Frame frame;
    const auto count = static_cast<double>(surface.points.size());
    for (const Vec3& point : surface.points) frame.center += point / count;
    Mat3 covariance = Mat3::Zero();
    for (const Vec3& point : surface.points) {
        covariance += (point - frame.center) * (point - frame.center).transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
    frame.moments = solver.eigenvalues().reverse();
    frame.axes = solver.eigenvectors().rowwise().reverse();
    if (frame.axes.determinant() < 0.0) frame.axes.col(2) *= -1.0;
    return frame;
}

/// Turns of the frame itself that its moments do not tell from each other.
std::vector<Mat3> open_turns(const Vec3& moments) {
    const bool first = moments[1] >= kAlike * moments[0];
    const bool last = moments[2] >= kAlike * moments[1];
    std::vector<Mat3> turns{Mat3::Identity()};
    const auto about = [&](int axis) {
        for (int turn = 1; turn < kStepsOfTurn / 4; ++turn) {
            const double angle = 2.0 * std::numbers::pi * turn / kStepsOfTurn;
            turns.push_back(Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix());
        }
        // The quarter turn, which changes the places of two axes.
        turns.push_back(
            Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::Unit(axis)).toRotationMatrix());
    };
    if (first) about(2);
    if (last) about(0);
    if (first && last) {
        about(1);
        Mat3 cycle;
        cycle << 0, 0, 1, 1, 0, 0, 0, 1, 0;
        turns.push_back(cycle);
        turns.emplace_back(cycle.transpose());
    }
    return turns;
}

}  // namespace

std::vector<Similarity> axis_candidates(const SurfacePoints& from, const SurfacePoints& to,
                                        const MotionKind& kind) {
    constexpr std::array<std::array<double, 2>, 4> kSigns{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
    const Frame a = frame_of(from);
    const Frame b = frame_of(to);
    const double scale =
        kind.scale && a.moments.sum() > 0.0 ? std::sqrt(b.moments.sum() / a.moments.sum()) : 1.0;
    std::vector<Similarity> candidates;
    for (const Mat3& turn : open_turns(a.moments)) {
        for (const auto& [x, y] : kSigns) {
            const Vec3 signs(x, y, (kind.mirror ? -1.0 : 1.0) * x * y);
            Similarity candidate;
            candidate.scale = scale;
            candidate.rotation = b.axes * signs.asDiagonal() * turn * a.axes.transpose();
            candidate.translation = b.center - scale * (candidate.rotation * a.center);
            candidates.push_back(candidate);
        }
    }
    return candidates;
}

}  // namespace ossuary::registration
