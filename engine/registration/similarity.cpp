#include "engine/registration/similarity.h"

#include <Eigen/SVD>
#include <cassert>

namespace ossuary::registration {

Similarity Similarity::inverse() const {
    Similarity back;
    back.scale = 1.0 / scale;
    back.rotation = rotation.transpose();
    back.translation = -back.scale * (back.rotation * translation);
    return back;
}

Eigen::Matrix4d Similarity::matrix() const {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = scale * rotation;
    matrix.topRightCorner<3, 1>() = translation;
    return matrix;
}

Similarity compose(const Similarity& outer, const Similarity& inner) {
    return {outer.scale * inner.scale, outer.rotation * inner.rotation,
            outer.point(inner.translation)};
}

Similarity fit_similarity(std::span<const Vec3> from, std::span<const Vec3> to,
                          const FitOptions& options) {
    assert(!from.empty() && from.size() == to.size());
    const auto count = static_cast<double>(from.size());
    Vec3 from_center = Vec3::Zero();
    Vec3 to_center = Vec3::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        from_center += from[i] / count;
        to_center += to[i] / count;
    }
    Mat3 covariance = Mat3::Zero();
    double variance = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Vec3 a = from[i] - from_center;
        covariance += (to[i] - to_center) * a.transpose() / count;
        variance += a.squaredNorm() / count;
    }
    const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double determinant = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    Vec3 signs(1.0, 1.0, 1.0);
    if ((determinant < 0.0) != options.mirror) signs.z() = -1.0;
    Similarity fit;
    fit.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    if (options.scale && variance > 0.0) {
        const double scale = svd.singularValues().dot(signs) / variance;
        if (scale > 0.0) fit.scale = scale;
    }
    fit.translation = to_center - fit.scale * (fit.rotation * from_center);
    return fit;
}

}  // namespace ossuary::registration
