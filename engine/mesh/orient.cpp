#include "engine/mesh/orient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "engine/mesh/edge_table.h"
#include "engine/mesh/measures.h"

namespace ossuary::mesh {
namespace {

constexpr std::uint32_t kNoPatch = 0xFFFFFFFFU;
/// How much of the cones' sizes their signed sum must be to say which way a patch faces: of closed
/// ones more than rounding, of open ones a bend of some thousandths.
constexpr double kClosedFacing = 1e-9, kOpenFacing = 1e-3;
constexpr double kSlant = 1e-6;  // the cosine from which on a flat patch does not stand upright

/// Sums over a patch.
struct Facing {
    double volume = 0.0;     ///< six times that under the patch, seen from the mean of its corners
    double magnitude = 0.0;  ///< of what is added up for it
    Vec3 center = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  ///< as long as twice the area of what does not cancel out
    double area = 0.0;           ///< twice
};

Facing facing_of(const TriangleMesh& mesh, std::span<const std::uint32_t> patch) {
    Facing facing;
    for (const std::uint32_t t : patch) {
        for (const Vec3& corner : mesh.corners(t)) facing.center += corner;
    }
    facing.center /= 3.0 * static_cast<double>(patch.size());
    for (const std::uint32_t t : patch) {
        const auto [a, b, c] = mesh.corners(t);
        const Vec3 base = (b - facing.center).cross(c - facing.center);
        facing.volume += (a - facing.center).dot(base);
        facing.magnitude += (a - facing.center).norm() * base.norm();
        const Vec3 normal = (b - a).cross(c - a);
        facing.normal += normal;
        facing.area += normal.norm();
    }
    return facing;
}

/// The convention for patches whose shape does not say which way they face.
bool faces_back(const Facing& facing, const Vec3& first_normal, const Vec3& center_of_surface) {
    const bool twisted = !(facing.normal.norm() > kSlant * facing.area);
    const Vec3& normal = twisted ? first_normal : facing.normal;
    const double length = normal.norm();
    const Vec3 away = facing.center - center_of_surface;
    const double slant = away.dot(normal);
    if (std::abs(slant) > kSlant * away.norm() * length) return slant < 0.0;
    for (const double along : normal) {
        if (std::abs(along) > kSlant * length) return along < 0.0;
    }
    return false;
}

class Orienting {
public:
    explicit Orienting(const TriangleMesh& mesh)
        : input_(mesh),
          table_(build_edge_table(mesh)),
          adjacent_(adjacent_triangles(mesh, table_)),
          center_(measure(mesh).area_centroid) {
        result_.mesh = mesh;
        result_.turned.assign(mesh.triangles.size(), 0);
        result_.patch_of.assign(mesh.triangles.size(), kNoPatch);
    }

    OrientResult run() {
        for (std::uint32_t seed = 0; seed < result_.patch_of.size(); ++seed) {
            if (result_.patch_of[seed] == kNoPatch) add_patch(seed);
        }
        count_edges_that_disagree();
        std::size_t begin = 0;
        for (OrientedPatch& patch : result_.patches) {
            face_outwards(patch, {members_.data() + begin, patch.triangles});
            begin += patch.triangles;
            result_.flipped_triangles += patch.turned;
        }
        return std::move(result_);
    }

private:
    /// Marks what has to be turned to face as `seed` does. Neighbours are reached in the order of
    /// their numbers: where not all can agree, those that do not are the same whichever way the
    /// triangles came.
    void add_patch(std::uint32_t seed) {
        const auto number = static_cast<std::uint32_t>(result_.patches.size());
        OrientedPatch& patch = result_.patches.emplace_back();
        patch.closed = true;
        const std::size_t begin = members_.size();
        members_.push_back(seed);
        result_.patch_of[seed] = number;
        for (std::size_t head = begin; head < members_.size(); ++head) {
            const std::uint32_t t = members_[head];
            std::array<std::pair<std::uint32_t, std::uint32_t>, 3> across;
            for (std::uint32_t side = 0; side < 3; ++side)
                across[side] = {adjacent_[t][side], side};
            std::sort(across.begin(), across.end());
            for (const auto& [other, side] : across) {
                if (other == kNoTriangle) {
                    patch.closed = false;
                    continue;
                }
                if (result_.patch_of[other] != kNoPatch) continue;
                result_.patch_of[other] = number;
                result_.turned[other] =
                    agree(t, side, other) ? result_.turned[t] : result_.turned[t] ^ 1;
                members_.push_back(other);
            }
        }
        patch.triangles = members_.size() - begin;
    }

    /// Whether the two run along that side of `triangle` opposite ways, as they came.
    [[nodiscard]] bool agree(std::uint32_t triangle, std::uint32_t side,
                             std::uint32_t other) const {
        const TriangleMesh::Triangle& far = input_.triangles[other];
        const auto from = input_.triangles[triangle][side];
        std::uint32_t back = 0;
        while (far[back] != from) ++back;
        return far[(back + 2) % 3] == input_.triangles[triangle][(side + 1) % 3];
    }

    void count_edges_that_disagree() {
        for (const EdgeTable::Edge& edge : table_.edges) {
            if (edge.side_count != 2) continue;
            const auto sides = table_.sides_of(edge);
            const bool first = goes_up(input_, sides[0]) != (result_.turned[sides[0] / 3] != 0);
            const bool second = goes_up(input_, sides[1]) != (result_.turned[sides[1] / 3] != 0);
            if (first != second) continue;
            ++result_.unorientable_edges;
            result_.patches[result_.patch_of[sides[0] / 3]].closed = false;
        }
    }

    void face_outwards(OrientedPatch& patch, std::span<const std::uint32_t> members) {
        const auto turn = [&](std::uint32_t t) { result_.mesh.turn_over(t); };
        for (const std::uint32_t t : members) {
            if (result_.turned[t] != 0) turn(t);
        }
        const Facing facing = facing_of(result_.mesh, members);
        const double least = (patch.closed ? kClosedFacing : kOpenFacing) * facing.magnitude;
        patch.sure = std::abs(facing.volume) > least;
        if (patch.sure ? facing.volume < 0.0 : faces_back(facing, normal_of(members[0]), center_)) {
            for (const std::uint32_t t : members) {
                turn(t);
                result_.turned[t] ^= 1;
            }
        }
        for (const std::uint32_t t : members) {
            patch.turned += result_.turned[t];
            for (const Vec3& corner : input_.corners(t)) patch.bounds.extend(corner);
        }
    }

    /// Of a triangle of the result, not of unit length.
    [[nodiscard]] Vec3 normal_of(std::uint32_t t) const {
        const auto [a, b, c] = result_.mesh.corners(t);
        return (b - a).cross(c - a);
    }

    const TriangleMesh& input_;
    EdgeTable table_;
    std::vector<std::array<std::uint32_t, 3>> adjacent_;
    Vec3 center_;
    std::vector<std::uint32_t> members_;  ///< of the patches, one after the other
    OrientResult result_;
};

}  // namespace

OrientResult orient(const TriangleMesh& mesh) { return Orienting(mesh).run(); }

}  // namespace ossuary::mesh
