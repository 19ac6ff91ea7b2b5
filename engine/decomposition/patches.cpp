#include "engine/decomposition/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "engine/mesh/disjoint_sets.h"
#include "engine/mesh/edge_table.h"
#include "engine/mesh/sample_surface.h"

namespace ossuary::decomposition {
namespace {

constexpr std::uint32_t kNoPatch = 0xFFFFFFFFU;
constexpr double kConcaveCost = 0.6;  // of a turn by 1, in patch diameters
constexpr double kConvexCost = 0.09;
constexpr double kSmallPiece = 1e-3;  // of the area
constexpr std::size_t kMaxSeededPieces = 100;
constexpr int kRounds = 3;
/// What one way must be shorter than another, and one middle better, in patch diameters.
constexpr float kClearly = 1e-4F;

class PatchGrowth {
public:
    PatchGrowth(const SurfaceGraph& surface, std::size_t count)
        : surface_(surface),
          diameter_(std::sqrt(surface.total_area / static_cast<double>(count))),
          costs_(surface.size(), {0.0F, 0.0F, 0.0F}) {
        for (std::size_t t = 0; t < surface.size(); ++t) {
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint32_t other = surface.across[t][side];
                if (other == mesh::kNoTriangle) continue;
                // A face belongs to one patch.
                if (surface.first_of_face[other] == surface.first_of_face[t]) continue;
                const double length = (surface.centers[other] - surface.centers[t]).norm();
                const double turn = static_cast<double>(surface.turns[t][side]);
                const double bend = turn > 0.0 ? kConcaveCost * turn : -kConvexCost * turn;
                costs_[t][side] = static_cast<float>(length / diameter_ + bend);
            }
        }
    }

    /// The nearest seed of each triangle; kNoPatch where none can be reached, or when stopped.
    std::vector<std::uint32_t> nearest(const std::vector<std::uint32_t>& seeds,
                                       const std::stop_token& stop) {
        constexpr float kLevelsPerUnit = 64.0F;
        std::vector<std::uint32_t> owner(surface_.size(), kNoPatch);
        distances_.assign(surface_.size(), std::numeric_limits<float>::infinity());
        std::vector<std::vector<std::uint32_t>> levels(1);
        for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
            if (owner[seeds[seed]] != kNoPatch) continue;
            owner[seeds[seed]] = seed;
            distances_[seeds[seed]] = 0.0F;
            levels[0].push_back(seeds[seed]);
        }
        const auto level_of = [](float distance) {
            return static_cast<std::size_t>(std::min(distance * kLevelsPerUnit, 1e6F));
        };
        // Levels are corrected until nothing in them changes: exact for any width of a level.
        for (std::size_t level = 0; level < levels.size() && !stop.stop_requested(); ++level) {
            for (std::size_t next = 0; next < levels[level].size(); ++next) {
                const std::uint32_t t = levels[level][next];
                if (level_of(distances_[t]) != level) continue;
                for (std::size_t side = 0; side < 3; ++side) {
                    const std::uint32_t other = surface_.across[t][side];
                    if (other == mesh::kNoTriangle) continue;
                    const float distance = distances_[t] + costs_[t][side];
                    if (distance >= distances_[other] - kClearly) continue;
                    distances_[other] = distance;
                    owner[other] = owner[t];
                    const std::size_t to = level_of(distance);
                    if (to >= levels.size()) levels.resize(to + 1);
                    levels[to].push_back(other);
                }
            }
        }
        return owner;
    }

    /// The triangle in the middle of each patch.
    std::vector<std::uint32_t> middles(const std::vector<std::uint32_t>& owner,
                                       std::vector<std::uint32_t> seeds) const {
        std::vector<Vec3> center(seeds.size(), Vec3::Zero()), normal(seeds.size(), Vec3::Zero());
        std::vector<double> area(seeds.size(), 0.0);
        for (std::size_t t = 0; t < owner.size(); ++t) {
            if (owner[t] == kNoPatch) continue;
            center[owner[t]] += surface_.areas[t] * surface_.centers[t];
            normal[owner[t]] += surface_.areas[t] * surface_.normals[t];
            area[owner[t]] += surface_.areas[t];
        }
        std::vector<double> best(seeds.size(), std::numeric_limits<double>::infinity());
        for (std::uint32_t t = 0; t < owner.size(); ++t) {
            const std::uint32_t p = owner[t];
            if (p == kNoPatch || area[p] <= 0.0) continue;
            const double away = (surface_.centers[t] - center[p] / area[p]).norm() / diameter_;
            const double turned = 1.0 - surface_.normals[t].dot(normal[p].normalized());
            if (away + 0.5 * turned < best[p] - static_cast<double>(kClearly)) {
                best[p] = away + 0.5 * turned;
                seeds[p] = t;
            }
        }
        return seeds;
    }

private:
    const SurfaceGraph& surface_;
    double diameter_;
    std::vector<std::array<float, 3>> costs_;
    std::vector<float> distances_;
};

/// Spread over the area, and at least one for each of the larger pieces.
std::vector<std::uint32_t> first_seeds(const mesh::TriangleMesh& mesh, const SurfaceGraph& surface,
                                       std::size_t count) {
    std::vector<std::uint32_t> seeds;
    for (const mesh::SurfaceSample& sample : mesh::sample_surface(mesh, {.count = count})) {
        const std::uint32_t triangle = surface.first_of_face[sample.triangle];
        if (seeds.empty() || seeds.back() != triangle) seeds.push_back(triangle);
    }
    const SurfacePieces pieces = surface_pieces(surface);
    std::vector<bool> seeded(pieces.areas.size(), false);
    for (const std::uint32_t seed : seeds) seeded[pieces.of_triangle[seed]] = true;
    std::size_t added = 0;
    for (std::uint32_t t = 0; t < surface.size() && added < kMaxSeededPieces; ++t) {
        const std::uint32_t piece = pieces.of_triangle[t];
        if (seeded[piece] || pieces.areas[piece] < kSmallPiece * surface.total_area) continue;
        seeded[piece] = true;
        seeds.push_back(t);
        ++added;
    }
    if (seeds.empty()) seeds.push_back(0);
    return seeds;
}

/// Ways of equal length, or triangles that do not touch, may have parted the triangles of a face.
void keep_faces_whole(const SurfaceGraph& surface, std::vector<std::uint32_t>& of_triangle) {
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        std::uint32_t& of_face = of_triangle[surface.first_of_face[t]];
        if (of_face == kNoPatch) of_face = of_triangle[t];
    }
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        of_triangle[t] = of_triangle[surface.first_of_face[t]];
    }
}

/// Makes faces patches of their own, the largest first, until there are `wanted`.
void part_until(std::size_t wanted, const SurfaceGraph& surface,
                std::vector<std::uint32_t>& of_triangle) {
    std::map<std::uint32_t, double> area_of_face;
    std::map<std::uint32_t, std::size_t> faces_of_patch;
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        area_of_face[surface.first_of_face[t]] += surface.areas[t];
        if (surface.first_of_face[t] == t) ++faces_of_patch[of_triangle[t]];
    }
    std::size_t patches = faces_of_patch.size() - faces_of_patch.count(kNoPatch);
    std::vector<std::pair<double, std::uint32_t>> faces;
    for (const auto& [face, area] : area_of_face) faces.emplace_back(-area, face);
    std::sort(faces.begin(), faces.end());
    auto next = static_cast<std::uint32_t>(surface.size());  // above all numbers in use
    std::map<std::uint32_t, std::uint32_t> parted;
    for (const auto& [negative_area, face] : faces) {
        if (patches >= wanted) break;
        std::size_t& left = faces_of_patch[of_triangle[face]];
        if (left < 2 && of_triangle[face] != kNoPatch) continue;
        --left;
        parted[face] = next++;
        ++patches;
    }
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        const auto found = parted.find(surface.first_of_face[t]);
        if (found != parted.end()) of_triangle[t] = found->second;
    }
}

/// Numbers the patches that have triangles and sums up what is in them.
void add_patches(const SurfaceGraph& surface, PatchGraph& graph) {
    std::vector<std::uint32_t> number;
    for (std::uint32_t& owner : graph.of_triangle) {
        if (owner == kNoPatch) continue;
        if (owner >= number.size()) number.resize(owner + 1, kNoPatch);
        if (number[owner] == kNoPatch) {
            number[owner] = static_cast<std::uint32_t>(graph.patches.size());
            graph.patches.emplace_back();
        }
        owner = number[owner];
    }
    std::vector<Vec3> plain(graph.size(), Vec3::Zero());
    for (std::size_t t = 0; t < surface.size(); ++t) {
        if (graph.of_triangle[t] == kNoPatch) continue;
        PatchGraph::Patch& patch = graph.patches[graph.of_triangle[t]];
        patch.center += surface.areas[t] * surface.centers[t];
        patch.normal += surface.areas[t] * surface.normals[t];
        patch.area += surface.areas[t];
        ++patch.triangles;
        plain[graph.of_triangle[t]] += surface.centers[t];
    }
    for (std::size_t p = 0; p < graph.size(); ++p) {
        PatchGraph::Patch& patch = graph.patches[p];
        patch.center = patch.area > 0.0 ? (patch.center / patch.area).eval()
                                        : (plain[p] / patch.triangles).eval();
        patch.normal.normalize();
    }
}

/// Triangles that no seed has reached join the patch whose centre is nearest.
void join_small_pieces(const SurfaceGraph& surface, PatchGraph& graph,
                       const std::stop_token& stop) {
    for (std::size_t t = 0; t < surface.size(); ++t) {
        if (graph.of_triangle[t] != kNoPatch) continue;
        if (stop.stop_requested()) return;
        if (surface.first_of_face[t] != t) {
            graph.of_triangle[t] = graph.of_triangle[surface.first_of_face[t]];
            ++graph.patches[graph.of_triangle[t]].triangles;
            continue;
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t p = 0; p < graph.size(); ++p) {
            const double distance = (graph.patches[p].center - surface.centers[t]).squaredNorm();
            if (distance >= nearest && graph.of_triangle[t] != kNoPatch) continue;
            nearest = distance;
            graph.of_triangle[t] = p;
        }
        ++graph.patches[graph.of_triangle[t]].triangles;
    }
}

void add_links(const SurfaceGraph& surface, PatchGraph& graph) {
    graph.links.resize(graph.size());
    const auto link = [&](std::uint32_t from, std::uint32_t to) -> PatchGraph::Link& {
        auto& links = graph.links[from];
        const auto at = std::find_if(links.begin(), links.end(),
                                     [&](const PatchGraph::Link& l) { return l.to == to; });
        return at != links.end() ? *at : links.emplace_back(PatchGraph::Link{to, 0.0, 0.0});
    };
    for (std::size_t t = 0; t < surface.size(); ++t) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t other = surface.across[t][side];
            if (other == mesh::kNoTriangle || graph.of_triangle[other] == graph.of_triangle[t])
                continue;
            PatchGraph::Link& to = link(graph.of_triangle[t], graph.of_triangle[other]);
            const double length = static_cast<double>(surface.side_lengths[t][side]);
            to.border += length;
            to.concavity += length * std::max(0.0, static_cast<double>(surface.turns[t][side]));
        }
    }
    for (auto& links : graph.links) {
        std::sort(links.begin(), links.end(),
                  [](const auto& a, const auto& b) { return a.to < b.to; });
        for (PatchGraph::Link& to : links) {
            if (to.border > 0.0) to.concavity /= to.border;
        }
    }
}

/// Links the nearest patches of different pieces, the nearest pieces first, until all hang
/// together.
void link_pieces(PatchGraph& graph) {
    const auto count = static_cast<std::uint32_t>(graph.size());
    mesh::DisjointSets sets(count);
    std::uint32_t pieces = count;
    const auto unite = [&](std::uint32_t a, std::uint32_t b) {
        if (sets.find(a) == sets.find(b)) return false;
        sets.unite(a, b);
        --pieces;
        return true;
    };
    for (std::uint32_t p = 0; p < count; ++p) {
        for (const PatchGraph::Link& link : graph.links[p]) unite(p, link.to);
    }
    if (pieces == 1) return;
    struct Gap {
        double distance;
        std::uint32_t a, b;
        bool operator<(const Gap& o) const {
            return std::tie(distance, a, b) < std::tie(o.distance, o.a, o.b);
        }
    };
    std::vector<Gap> gaps;
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a + 1; b < count; ++b) {
            if (sets.find(a) == sets.find(b)) continue;
            gaps.push_back({(graph.patches[a].center - graph.patches[b].center).norm(), a, b});
        }
    }
    std::sort(gaps.begin(), gaps.end());
    for (const Gap& gap : gaps) {
        if (!unite(gap.a, gap.b)) continue;
        graph.links[gap.a].push_back({gap.b, 0.0, 0.0});
        graph.links[gap.b].push_back({gap.a, 0.0, 0.0});
    }
}

}  // namespace

PatchGraph patch_graph(const mesh::TriangleMesh& mesh, const SurfaceGraph& surface,
                       const PatchGraphOptions& options, const std::stop_token& stop) {
    PatchGraph graph;
    if (surface.size() == 0) return graph;
    PatchGrowth growth(surface, options.count);
    std::vector<std::uint32_t> seeds = first_seeds(mesh, surface, options.count);
    for (int round = 0; round < kRounds; ++round) {
        if (round > 0) seeds = growth.middles(graph.of_triangle, std::move(seeds));
        graph.of_triangle = growth.nearest(seeds, stop);
        if (stop.stop_requested()) return graph;
    }
    keep_faces_whole(surface, graph.of_triangle);
    if (options.at_least > 0) part_until(options.at_least, surface, graph.of_triangle);
    graph.total_area = surface.total_area;
    add_patches(surface, graph);
    join_small_pieces(surface, graph, stop);
    if (stop.stop_requested()) return graph;
    add_links(surface, graph);
    link_pieces(graph);
    return graph;
}

}  // namespace ossuary::decomposition
