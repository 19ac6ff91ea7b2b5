#include "engine/skeleton/tube_radii.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

namespace ossuary::skeleton {
namespace {

/// How much of a point's inscribed ball is its own beside nearer points.
constexpr double kBallShare = 0.8;
/// Voxels along each edge of a cell whose voxels share their candidates.
constexpr int kCellSize = 8;

/// The middle of a stretch of branch about one voxel long.
struct Stretch {
    Vec3f point = Vec3f::Zero();
    float ball = 0.0F;  ///< share of the squared inscribed radius
};

/// A branch cut into stretches of equal length.
struct CutBranch {
    std::vector<double> along;  ///< arc length at each of the branch's points
    std::size_t first = 0;      ///< of its stretches
    std::size_t count = 0;
    double step = 0.0;
};

CutBranch cut(const SkeletonGraph::Branch& branch, std::vector<Stretch>& stretches) {
    CutBranch result;
    result.along.assign(branch.points.size(), 0.0);
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
        result.along[i] = result.along[i - 1] + (branch.points[i] - branch.points[i - 1]).norm();
    }
    const double length = result.along.back();
    result.first = stretches.size();
    result.count = static_cast<std::size_t>(std::max(1.0, std::round(length)));
    result.step = length / static_cast<double>(result.count);
    std::size_t i = 0;
    for (std::size_t k = 0; k < result.count; ++k) {
        const double at = (static_cast<double>(k) + 0.5) * result.step;
        while (i + 2 < result.along.size() && result.along[i + 1] < at) ++i;
        const double span = result.along[i + 1] - result.along[i];
        const double t = span > 0.0 ? std::clamp((at - result.along[i]) / span, 0.0, 1.0) : 0.0;
        const Vec3 point = (1.0 - t) * branch.points[i] + t * branch.points[i + 1];
        const double radius = (1.0 - t) * branch.radii[i] + t * branch.radii[i + 1];
        stretches.push_back(
            {point.cast<float>(), static_cast<float>(kBallShare * radius * radius)});
    }
    return result;
}

/// Which voxels of a row are in the cell that begins at x; a cell never straddles words.
unsigned cell_bits(std::span<const std::uint64_t> row, int x) {
    const std::uint64_t word = row[static_cast<std::size_t>(x) >> 6];
    constexpr std::uint64_t kMask = (std::uint64_t{1} << kCellSize) - 1;
    return static_cast<unsigned>((word >> (static_cast<unsigned>(x) & 63U)) & kMask);
}

/// Gives each block of eight voxels to the stretch that its middle is nearest to.
class VoxelShares {
public:
    VoxelShares(std::span<const Stretch> stretches, const voxel::BitVolume& solid)
        : stretches_(stretches), solid_(solid), voxels_(stretches.size(), 0.0) {
        const Vec3i& size = solid.size();
        for (int z = 0; z < size.z(); z += kCellSize) {
            for (int y = 0; y < size.y(); y += kCellSize) {
                for (int x = 0; x < size.x(); x += kCellSize) share_cell({x, y, z});
            }
        }
    }
    [[nodiscard]] const std::vector<double>& voxels() const { return voxels_; }

private:
    void share_cell(const Vec3i& corner) {
        const Vec3i end = (corner + Vec3i::Constant(kCellSize)).cwiseMin(solid_.size());
        bool gathered = false;
        for (int z = corner.z(); z < end.z(); z += 2) {
            for (int y = corner.y(); y < end.y(); y += 2) {
                std::array<unsigned, 4> rows{};
                for (int k = 0; k < 4; ++k) {
                    const int row_y = y + k % 2, row_z = z + k / 2;
                    if (row_y >= end.y() || row_z >= end.z()) continue;
                    rows[static_cast<std::size_t>(k)] =
                        cell_bits(solid_.row(row_y, row_z), corner.x());
                }
                if ((rows[0] | rows[1] | rows[2] | rows[3]) == 0) continue;
                if (!gathered) gather_candidates(corner);
                gathered = true;
                share_blocks({corner.x(), y, z}, rows);
            }
        }
    }

    /// Blocks of two by two by two voxels along four neighbouring rows: each goes as a whole.
    void share_blocks(const Vec3i& corner, const std::array<unsigned, 4>& rows) {
        for (int x = 0; x < kCellSize; x += 2) {
            int count = 0;
            for (const unsigned row : rows) count += std::popcount((row >> x) & 3U);
            if (count == 0) continue;
            const Vec3i block = corner + Vec3i(x, 0, 0);
            voxels_[nearest(block.cast<float>() + Vec3f::Ones())] += static_cast<double>(count);
        }
    }

    /// The stretches that can be nearest to some point of a cell.
    void gather_candidates(const Vec3i& corner) {
        const Vec3f middle = corner.cast<float>() + Vec3f::Constant(0.5F * kCellSize);
        const float reach = 0.5F * kCellSize * std::numbers::sqrt3_v<float>;
        lower_.resize(stretches_.size());
        float least_upper = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const float distance = (stretches_[i].point - middle).norm();
            const float near = std::max(0.0F, distance - reach);
            const float far = distance + reach;
            lower_[i] = near * near - stretches_[i].ball;
            least_upper = std::min(least_upper, far * far - stretches_[i].ball);
        }
        candidates_.clear();
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            if (lower_[i] <= least_upper) candidates_.push_back(i);
        }
    }

    /// Of equally near ones the first.
    [[nodiscard]] std::size_t nearest(const Vec3f& point) const {
        std::size_t best = candidates_.front();
        float least = std::numeric_limits<float>::infinity();
        for (const std::size_t i : candidates_) {
            const float distance = (stretches_[i].point - point).squaredNorm() - stretches_[i].ball;
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    std::span<const Stretch> stretches_;
    const voxel::BitVolume& solid_;
    std::vector<double> voxels_;
    std::vector<float> lower_;
    std::vector<std::size_t> candidates_;
};

/// The cylinder's radius around one point: voxels and length of the stretches about it, the nearer
/// ones counting more.
double radius_at(const CutBranch& branch, std::span<const double> voxels, double along,
                 double inscribed) {
    const double reach = std::max(1.5, 0.5 * inscribed);
    double volume = 0.0, length = 0.0;
    for (std::size_t k = 0; k < branch.count; ++k) {
        const double distance =
            std::abs((static_cast<double>(k) + 0.5) * branch.step - along) / reach;
        if (distance >= 1.0) continue;
        volume += (1.0 - distance) * voxels[branch.first + k];
        length += (1.0 - distance) * branch.step;
    }
    if (length <= 0.0) return inscribed;
    constexpr double kLeastVolume = 0.3;  // of a voxel: a stretch between others may get nothing
    return std::sqrt(std::max(volume, kLeastVolume) / (std::numbers::pi * length));
}

}  // namespace

std::vector<std::vector<double>> tube_radii(const SkeletonGraph& graph,
                                            const voxel::BitVolume& solid) {
    std::vector<Stretch> stretches;
    std::vector<CutBranch> branches;
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        branches.push_back(cut(branch, stretches));
    }
    std::vector<std::vector<double>> radii(graph.branches.size());
    if (stretches.empty()) return radii;
    const VoxelShares shares(stretches, solid);
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const SkeletonGraph::Branch& branch = graph.branches[b];
        for (std::size_t i = 0; i < branch.points.size(); ++i) {
            radii[b].push_back(
                radius_at(branches[b], shares.voxels(), branches[b].along[i], branch.radii[i]));
        }
    }
    return radii;
}

double tube_volume(const SkeletonGraph& graph) {
    double volume = 0.0;
    for (const SkeletonGraph::Branch& branch : graph.branches) {
        for (std::size_t i = 1; i < branch.points.size(); ++i) {
            const double radius = 0.5 * (branch.radii[i - 1] + branch.radii[i]);
            volume += std::numbers::pi * radius * radius *
                      (branch.points[i] - branch.points[i - 1]).norm();
        }
    }
    return volume;
}

}  // namespace ossuary::skeleton
