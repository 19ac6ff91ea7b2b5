#include "engine/mesh/nearby_groups.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kReachCells = 2;
constexpr std::size_t kMaxSamples = 20'000'000;  // inside triangles

/// The steps from a cell to those behind it that are within reach.
std::vector<std::uint32_t> steps_forward(std::uint32_t along) {
    constexpr int kReach = static_cast<int>(kReachCells);
    std::vector<std::uint32_t> steps;
    for (int z = -kReach; z <= kReach; ++z) {
        for (int y = -kReach; y <= kReach; ++y) {
            for (int x = -kReach; x <= kReach; ++x) {
                const int step = (z * static_cast<int>(along) + y) * static_cast<int>(along) + x;
                if (step > 0) steps.push_back(static_cast<std::uint32_t>(step));
            }
        }
    }
    return steps;
}

}  // namespace

NearbyGrouper::NearbyGrouper(const TriangleMesh& mesh, const Mat3& axes, double reach)
    : mesh_(mesh), cells_along_(static_cast<std::uint32_t>(kReachCells / reach)) {
    assert(reach >= 1.0 / 48 && reach <= 0.25);
    const Mat3 turned = axes.transpose();
    positions_.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) positions_.push_back(turned * vertex);
    const std::size_t along = cells_along_ + 2 * kReachCells;
    place_of_.assign(along * along * along, kNoPlace);
}

Box3 NearbyGrouper::box_of(std::span<const std::uint32_t> triangles) const {
    Box3 box;
    for (const std::uint32_t t : triangles) {
        for (const std::uint32_t v : mesh_.triangles[t]) box.extend(positions_[v]);
    }
    return box;
}

/// As many empty cells as neighbours reach lie around the box, so that steps need no guard.
std::uint32_t NearbyGrouper::cell_of(const Vec3& position) const {
    const std::uint32_t along = cells_along_ + 2 * kReachCells;
    std::uint32_t cell = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const double at = (position[axis] - low_[axis]) / cell_size_;
        const double inside = std::clamp(at, 0.0, cells_along_ - 1.0);
        cell = cell * along + kReachCells + static_cast<std::uint32_t>(inside);
    }
    return cell;
}

/// The place of the position's cell among the occupied ones.
std::uint32_t NearbyGrouper::occupy(const Vec3& position) {
    const std::uint32_t cell = cell_of(position);
    if (place_of_[cell] == kNoPlace) {
        place_of_[cell] = sets_.add();
        occupied_.push_back(cell);
    }
    return place_of_[cell];
}

void NearbyGrouper::occupy_corners(std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t t : triangles) {
        const auto& [i, j, k] = mesh_.triangles[t];
        const std::uint32_t first = occupy(positions_[i]);
        sets_.unite(first, occupy(positions_[j]));
        sets_.unite(first, occupy(positions_[k]));
    }
}

/// Occupies cells at most one apart all over the triangles; false where that would take too long.
bool NearbyGrouper::occupy_insides(std::span<const std::uint32_t> triangles,
                                   const std::stop_token& stop) {
    std::size_t samples = 0;
    for (const std::uint32_t t : triangles) {
        const auto& [i, j, k] = mesh_.triangles[t];
        const Vec3 &a = positions_[i], &b = positions_[j], &c = positions_[k];
        const Vec3 longest =
            (b - a).cwiseAbs().cwiseMax((c - a).cwiseAbs()).cwiseMax((c - b).cwiseAbs());
        const auto steps = static_cast<std::size_t>(std::ceil(longest.maxCoeff() / cell_size_));
        if (steps < 2) continue;
        samples += (steps + 1) * (steps + 2) / 2;
        if (samples > kMaxSamples || stop.stop_requested()) return false;
        const Vec3 along_b = (b - a) / static_cast<double>(steps);
        const Vec3 along_c = (c - a) / static_cast<double>(steps);
        const std::uint32_t first = occupy(a);
        for (std::size_t u = 0; u <= steps; ++u) {
            for (std::size_t v = 0; u + v <= steps; ++v) {
                const Vec3 inside =
                    a + static_cast<double>(u) * along_b + static_cast<double>(v) * along_c;
                sets_.unite(first, occupy(inside));
            }
        }
    }
    return true;
}

std::uint32_t NearbyGrouper::link_neighbors() {
    const std::vector<std::uint32_t> steps = steps_forward(cells_along_ + 2 * kReachCells);
    for (std::uint32_t place = 0; place < occupied_.size(); ++place) {
        for (const std::uint32_t step : steps) {
            const std::uint32_t other = place_of_[occupied_[place] + step];
            if (other != kNoPlace) sets_.unite(place, other);
        }
    }
    std::uint32_t count = 0;
    for (std::uint32_t place = 0; place < occupied_.size(); ++place) {
        count += sets_.find(place) == place ? 1 : 0;
    }
    return count;
}

NearbyGroups NearbyGrouper::numbered(std::span<const std::uint32_t> triangles) {
    NearbyGroups groups;
    groups.of.reserve(triangles.size());
    std::vector<std::uint32_t> number(occupied_.size(), kNoPlace);
    for (const std::uint32_t t : triangles) {
        const std::uint32_t place = place_of_[cell_of(positions_[mesh_.triangles[t][0]])];
        std::uint32_t& group = number[sets_.find(place)];
        if (group == kNoPlace) group = groups.count++;
        groups.of.push_back(group);
    }
    return groups;
}

void NearbyGrouper::clear() {
    for (const std::uint32_t cell : occupied_) place_of_[cell] = kNoPlace;
    occupied_.clear();
    sets_ = DisjointSets(0);
}

NearbyGroups NearbyGrouper::group(std::span<const std::uint32_t> triangles,
                                  const std::stop_token& stop) {
    NearbyGroups one = {1, std::vector<std::uint32_t>(triangles.size(), 0)};
    const Box3 box = box_of(triangles);
    if (triangles.size() < 2 || !(box.sizes().maxCoeff() > 0)) return one;
    low_ = box.min();
    cell_size_ = box.sizes().maxCoeff() / cells_along_;
    if (!(cell_size_ > 0) || !std::isfinite(cell_size_)) return one;

    // Corners tell most models, and every fine one, to be of one group.
    occupy_corners(triangles);
    std::uint32_t count = link_neighbors();
    if (count > 1 && occupy_insides(triangles, stop)) {
        count = link_neighbors();
    } else {
        count = 1;
    }
    NearbyGroups groups = count > 1 ? numbered(triangles) : one;
    clear();
    return groups;
}

}  // namespace ossuary::mesh
