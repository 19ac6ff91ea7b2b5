#include "tests/benchmarks/cut_pieces.h"

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

#include "engine/decomposition/seg_file.h"
#include "engine/mesh/components.h"
#include "engine/mesh/measures.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace ossuary::benchmarks {
namespace {

constexpr double kLeastShare = 0.08;
constexpr double kMostShare = 0.40;

}  // namespace

mesh::TriangleMesh cut_out(const mesh::TriangleMesh& mesh, const std::vector<std::size_t>& kept) {
    mesh::TriangleMesh part;
    std::map<std::uint32_t, std::uint32_t> place;
    for (const std::size_t face : kept) {
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.triangles[face][k];
            const auto [found, is_new] =
                place.emplace(vertex, static_cast<std::uint32_t>(part.vertices.size()));
            if (is_new) part.vertices.push_back(mesh.vertices[vertex]);
            triangle[k] = found->second;
        }
        part.face_of_triangle.push_back(static_cast<std::uint32_t>(part.triangles.size()));
        part.triangles.push_back(triangle);
    }
    part.face_count = static_cast<std::uint32_t>(part.triangles.size());
    return part;
}

mesh::TriangleMesh with_holes_closed(const mesh::TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
    }
    std::multimap<std::uint32_t, std::uint32_t> next;  // the other way round, along holes
    for (const auto& [edge, count] : edges) {
        if (!edges.contains({edge.second, edge.first})) next.emplace(edge.second, edge.first);
    }
    mesh::TriangleMesh closed = mesh;
    while (!next.empty()) {
        std::vector<std::uint32_t> loop{next.begin()->first};
        for (auto step = next.find(loop.back()); step != next.end();
             step = next.find(loop.back())) {
            loop.push_back(step->second);
            next.erase(step);
            if (loop.back() == loop.front()) break;
        }
        Vec3 middle = Vec3::Zero();
        for (std::size_t i = 1; i < loop.size(); ++i) {
            middle += mesh.vertices[loop[i]] / static_cast<double>(loop.size() - 1);
        }
        const auto center = static_cast<std::uint32_t>(closed.vertices.size());
        closed.vertices.push_back(middle);
        for (std::size_t i = 1; i < loop.size(); ++i) {
            closed.face_of_triangle.push_back(closed.face_count++);
            closed.triangles.push_back({loop[i - 1], loop[i], center});
        }
    }
    return closed;
}

std::optional<CutPiece> cut_piece(const mesh::TriangleMesh& mesh,
                                  const std::filesystem::path& segmentations,
                                  const std::string& name, std::uint64_t seed) {
    const auto read = decomposition::read_segmentations(segmentations, name, mesh.triangles.size());
    if (!read) throw std::runtime_error(read.error().message);
    if (read->empty()) return std::nullopt;
    std::mt19937_64 random(seed);
    const auto& labels = (*read)[test::next_below(random, read->size())].labels;
    std::map<std::uint32_t, std::vector<std::size_t>> faces_of_label;
    for (std::size_t face = 0; face < labels.size(); ++face) {
        faces_of_label[labels[face]].push_back(face);
    }
    const double whole = mesh::measure(mesh).surface_area;
    std::vector<CutPiece> pieces;
    for (const auto& [label, faces] : faces_of_label) {
        const mesh::MeshComponents components = mesh::connected_components(cut_out(mesh, faces));
        std::vector<std::vector<std::size_t>> of_component(components.count);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            of_component[components.of_triangle[i]].push_back(faces[i]);
        }
        for (auto& kept : of_component) {
            CutPiece piece{cut_out(mesh, kept), std::move(kept)};
            piece.share = mesh::measure(piece.mesh).surface_area / whole;
            if (piece.share >= kLeastShare && piece.share <= kMostShare) {
                pieces.push_back(std::move(piece));
            }
        }
    }
    if (pieces.empty()) return std::nullopt;
    return std::move(pieces[test::next_below(random, pieces.size())]);
}

mesh::TriangleMesh moved_at_random(const mesh::TriangleMesh& mesh, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const double scale = std::pow(10.0, 2.0 * test::next_unit(random) - 1.0);
    const Vec3 way(test::next_unit(random), test::next_unit(random), test::next_unit(random));
    return test::transformed(mesh, scale * test::random_rotation(seed), 5.0 * scale * way);
}

}  // namespace ossuary::benchmarks
