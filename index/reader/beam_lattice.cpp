#include "index/reader/beam_lattice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace ossuary::index {
namespace {

/// Around a circle of radius 1, starting anywhere.
std::vector<Eigen::Vector2d> circle(std::uint32_t sides) {
    // The polygon that has the circle's area.
    const double turn = 2 * std::numbers::pi / sides;
    const double radius = std::sqrt(turn / std::sin(turn));
    std::vector<Eigen::Vector2d> points;
    for (std::uint32_t i = 0; i < sides; ++i) {
        points.emplace_back(radius * std::cos(turn * i), radius * std::sin(turn * i));
    }
    return points;
}

/// Closed surfaces of rings around an axis, one after the other, into one mesh.
class Turner {
public:
    Turner(mesh::TriangleMesh& mesh, std::uint32_t sides)
        : mesh_(mesh), sides_(sides), circle_(circle(sides)) {}

    /// Starts with the point that closes the first ring.
    void begin(const Vec3& axis, const Vec3& point) {
        across_ = axis.unitOrthogonal();
        up_ = axis.cross(across_);
        ring_ = kNone;
        last_ = add(point);
    }
    /// A ring further along the axis.
    void ring(const Vec3& middle, double radius) {
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const Eigen::Vector2d& at : circle_) {
            add(middle + radius * (at.x() * across_ + at.y() * up_));
        }
        for (std::uint32_t i = 0; i < sides_; ++i) {
            const std::uint32_t next = (i + 1) % sides_;
            if (ring_ == kNone) {
                mesh_.triangles.push_back({last_, first + next, first + i});
            } else {
                mesh_.triangles.push_back({ring_ + i, ring_ + next, first + next});
                mesh_.triangles.push_back({ring_ + i, first + next, first + i});
            }
        }
        ring_ = first;
    }
    void end(const Vec3& point) {
        const std::uint32_t last = add(point);
        for (std::uint32_t i = 0; i < sides_; ++i) {
            mesh_.triangles.push_back({last, ring_ + i, ring_ + (i + 1) % sides_});
        }
    }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    std::uint32_t add(const Vec3& point) {
        mesh_.vertices.push_back(point);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    mesh::TriangleMesh& mesh_;
    std::uint32_t sides_;
    std::vector<Eigen::Vector2d> circle_;
    Vec3 across_ = Vec3::Zero();
    Vec3 up_ = Vec3::Zero();
    std::uint32_t last_ = 0;
    std::uint32_t ring_ = kNone;  ///< first of the last one
};

/// Steps of a quarter turn.
std::uint32_t quarter_steps(std::uint32_t sides) { return std::max(sides / 4, 2u); }

struct LatticeCounts {
    std::uint64_t struts = 0;
    std::uint64_t hemispheres = 0;
    std::uint64_t balls = 0;

    [[nodiscard]] std::uint64_t vertices(std::uint64_t sides) const {
        const std::uint64_t quarter = quarter_steps(static_cast<std::uint32_t>(sides));
        return struts * (2 * sides + 2) + hemispheres * (quarter - 1) * sides +
               balls * ((2 * quarter - 1) * sides + 2);
    }
    [[nodiscard]] std::uint64_t triangles(std::uint64_t sides) const {
        const std::uint64_t quarter = quarter_steps(static_cast<std::uint32_t>(sides));
        return struts * 4 * sides + hemispheres * (quarter - 1) * 2 * sides +
               balls * (2 * quarter - 1) * 2 * sides;
    }
};

std::uint32_t sides_for(const LatticeCounts& counts) {
    constexpr std::uint64_t kEnough = 500'000;  // triangles
    for (const std::uint32_t sides : {24u, 16u, 12u, 8u}) {
        if (counts.triangles(sides) <= kEnough) return sides;
    }
    return 6;
}

void add_ball(Turner& turner, std::uint32_t sides, const Vec3& middle, double radius) {
    const std::uint32_t steps = 2 * quarter_steps(sides);
    const Vec3 axis = Vec3::UnitZ();
    turner.begin(axis, middle - radius * axis);
    for (std::uint32_t i = 1; i < steps; ++i) {
        const double angle = std::numbers::pi * i / steps;
        turner.ring(middle - radius * std::cos(angle) * axis, radius * std::sin(angle));
    }
    turner.end(middle + radius * axis);
}

void add_strut(Turner& turner, std::uint32_t sides, const std::array<Vec3, 2>& ends,
               const Beam& beam) {
    const Vec3 axis = (ends[1] - ends[0]).normalized();
    const std::uint32_t steps = quarter_steps(sides);
    const auto reach = [&](std::size_t end) {
        return beam.caps[end] == BeamCap::kHemisphere ? beam.radii[end] : 0.0;
    };
    const auto rings_of_cap = [&](std::size_t end, std::uint32_t step) {
        const double angle = std::numbers::pi / 2 * step / steps;
        const double along = beam.radii[end] * std::sin(angle) * (end == 0 ? -1 : 1);
        turner.ring(ends[end] + along * axis, beam.radii[end] * std::cos(angle));
    };
    turner.begin(axis, ends[0] - reach(0) * axis);
    const std::uint32_t before = beam.caps[0] == BeamCap::kHemisphere ? steps : 1;
    for (std::uint32_t step = before; step-- > 0;) rings_of_cap(0, step);
    const std::uint32_t after = beam.caps[1] == BeamCap::kHemisphere ? steps : 1;
    for (std::uint32_t step = 0; step < after; ++step) rings_of_cap(1, step);
    turner.end(ends[1] + reach(1) * axis);
}

Error invalid(const std::string& expected, std::size_t beam) {
    return {ErrorCode::kThreeMfInvalid,
            "expected " + expected + ", found another in beam " + std::to_string(beam)};
}

Result<void> check(std::span<const Vec3> nodes, std::span<const Beam> beams) {
    for (std::size_t i = 0; i < beams.size(); ++i) {
        for (std::size_t end = 0; end < 2; ++end) {
            if (beams[i].nodes[end] >= nodes.size()) return invalid("ends that are vertices", i);
            if (!std::isfinite(beams[i].radii[end]) || beams[i].radii[end] <= 0.0) {
                return invalid("radii that are positive numbers", i);
            }
        }
    }
    return {};
}

Result<void> check_counts(const LatticeCounts& counts, std::uint32_t sides,
                          const mesh::ReadMeshOptions& caps) {
    const std::uint64_t vertices = counts.vertices(sides);
    const std::uint64_t triangles = counts.triangles(sides);
    if (vertices > caps.max_vertices) {
        return {ErrorCode::kModelTooManyVertices,
                "expected at most " + std::to_string(caps.max_vertices) + " vertices, found " +
                    std::to_string(vertices) + " of " + std::to_string(counts.struts) + " beams"};
    }
    if (triangles > caps.max_faces) {
        return {ErrorCode::kModelTooManyFaces,
                "expected at most " + std::to_string(caps.max_faces) + " faces, found " +
                    std::to_string(triangles) + " of " + std::to_string(counts.struts) + " beams"};
    }
    return {};
}

}  // namespace

Result<mesh::TriangleMesh> beam_lattice_surface(std::span<const Vec3> nodes,
                                                std::span<const Beam> beams,
                                                const mesh::ReadMeshOptions& caps) {
    if (const auto checked = check(nodes, beams); !checked) return checked.error();
    LatticeCounts counts;
    std::map<std::uint32_t, double> balls;  // the largest around a node holds the others
    const auto has_length = [&](const Beam& beam) {
        return nodes[beam.nodes[0]] != nodes[beam.nodes[1]];
    };
    for (const Beam& beam : beams) {
        const bool is_strut = has_length(beam);
        counts.struts += is_strut ? 1 : 0;
        for (std::size_t end = 0; end < 2; ++end) {
            if (beam.caps[end] == BeamCap::kSphere) {
                double& radius = balls[beam.nodes[end]];
                radius = std::max(radius, beam.radii[end]);
            }
            counts.hemispheres += is_strut && beam.caps[end] == BeamCap::kHemisphere ? 1 : 0;
        }
    }
    counts.balls = balls.size();
    const std::uint32_t sides = sides_for(counts);
    if (const auto checked = check_counts(counts, sides, caps); !checked) return checked.error();
    mesh::TriangleMesh mesh;
    mesh.vertices.reserve(counts.vertices(sides));
    mesh.triangles.reserve(counts.triangles(sides));
    Turner turner(mesh, sides);
    for (const Beam& beam : beams) {
        if (!has_length(beam)) continue;
        add_strut(turner, sides, {nodes[beam.nodes[0]], nodes[beam.nodes[1]]}, beam);
    }
    for (const auto& [node, radius] : balls) add_ball(turner, sides, nodes[node], radius);
    return mesh;
}

}  // namespace ossuary::index
