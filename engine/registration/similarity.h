#pragma once

#include <span>
#include <vector>

#include "engine/core/geometry.h"

namespace ossuary::registration {

/// x becomes scale * rotation * x + translation.
struct Similarity {
    double scale = 1.0;                ///< > 0
    Mat3 rotation = Mat3::Identity();  ///< orthonormal; determinant -1 where it mirrors
    Vec3 translation = Vec3::Zero();

    [[nodiscard]] Vec3 point(const Vec3& x) const { return scale * (rotation * x) + translation; }
    /// Of a unit normal; what faces outwards does so afterwards, also when mirrored.
    [[nodiscard]] Vec3 normal(const Vec3& n) const { return rotation * n; }
    [[nodiscard]] bool mirrors() const { return rotation.determinant() < 0.0; }
    [[nodiscard]] Similarity inverse() const;
    /// Homogeneous, for column vectors.
    [[nodiscard]] Eigen::Matrix4d matrix() const;
};

/// First `inner`, then `outer`.
[[nodiscard]] Similarity compose(const Similarity& outer, const Similarity& inner);

struct FitOptions {
    bool scale = false;   ///< else it is 1
    bool mirror = false;  ///< the result mirrors
};

/// The similarity that brings each of `from` nearest to its fellow in `to` by the sum of squares
/// (Umeyama, Least-Squares Estimation of Transformation Parameters Between Two Point Patterns,
/// 1991, eq. 40-42). Where points leave a turn open it is some one of the best.
/// @pre as many points in both, at least one
[[nodiscard]] Similarity fit_similarity(std::span<const Vec3> from, std::span<const Vec3> to,
                                        const FitOptions& options = {});

}  // namespace ossuary::registration
