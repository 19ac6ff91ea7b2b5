// How far a model is from itself when something that is no part of it lies far away: a face that is
// a point, a line or a needle, or a speck of a thousandth of its size, at 2 to a million times its
// size. One model of each class of the Princeton segmentation benchmark, all three rankers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/ranker.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace {

using namespace ossuary;

constexpr int kModelsOfAClass = 20;
constexpr int kClasses = 19;
constexpr double kSpeckSize = 1e-3;  // of the model's
constexpr double kDistances[] = {2, 20, 2000, 1e6};

mesh::TriangleMesh with_face(mesh::TriangleMesh mesh, const std::vector<Vec3>& corners,
                             mesh::TriangleMesh::Triangle triangle) {
    for (std::uint32_t& corner : triangle) {
        corner += static_cast<std::uint32_t>(mesh.vertices.size());
    }
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back(triangle);
    mesh.face_of_triangle.push_back(mesh.face_count++);
    return mesh;
}

mesh::TriangleMesh with_point(const mesh::TriangleMesh& mesh, const Vec3& place, double) {
    return with_face(mesh, {place}, {0, 0, 0});
}

mesh::TriangleMesh with_line(const mesh::TriangleMesh& mesh, const Vec3& place, double) {
    return with_face(mesh, {mesh.vertices[mesh.triangles[0][0]], place}, {0, 1, 1});
}

mesh::TriangleMesh with_needle(const mesh::TriangleMesh& mesh, const Vec3& place, double) {
    const Vec3& root = mesh.vertices[mesh.triangles[0][0]];
    return with_face(mesh, {root, place, (root + place) / 2}, {0, 1, 2});
}

mesh::TriangleMesh with_speck(const mesh::TriangleMesh& mesh, const Vec3& place, double size) {
    return test::merged(mesh, test::icosphere_mesh(place, kSpeckSize * size / 2, 1));
}

struct Kind {
    const char* name;
    mesh::TriangleMesh (*add)(const mesh::TriangleMesh&, const Vec3&, double size);
};
constexpr Kind kKinds[] = {
    {"point", with_point}, {"line", with_line}, {"needle", with_needle}, {"speck", with_speck}};

descriptor::ModelDescriptor descriptor_of(const mesh::TriangleMesh& mesh) {
    auto description = descriptor::describe(mesh);
    if (!description) throw std::runtime_error(description.error().message);
    return std::move(description->descriptor);
}

std::vector<mesh::TriangleMesh> read_models(const std::filesystem::path& folder) {
    std::vector<mesh::TriangleMesh> models;
    for (int i = 0; i <= kClasses; ++i) {
        const auto path = folder / (std::to_string(1 + kModelsOfAClass * i) + ".off");
        if (!std::filesystem::exists(path)) continue;  // one class's numbers are not taken
        auto read = mesh::read_mesh(path);
        if (!read) throw std::runtime_error(read.error().message);
        models.push_back(std::move(read->mesh));
    }
    return models;
}

void run(const std::filesystem::path& folder) {
    const std::vector<mesh::TriangleMesh> models = read_models(folder);
    std::vector<descriptor::ModelDescriptor> originals(models.size());
    parallel_for(models.size(), 2, [&](std::size_t i) { originals[i] = descriptor_of(models[i]); });
    std::vector<const descriptor::ModelDescriptor*> pointers;
    for (const auto& original : originals) pointers.push_back(&original);
    const auto statistics = *ranking::collection_statistics(pointers, 2);
    std::cout << fmt::format("{} models; the largest distance to itself\n", models.size())
              << "what     at      hybrid  skeleton  chain-code\n";
    for (const Kind& kind : kKinds) {
        for (const double distance : kDistances) {
            std::vector<std::array<double, 3>> distances(models.size());
            parallel_for(models.size(), 2, [&](std::size_t i) {
                const mesh::MeshMeasures measures = mesh::measure(models[i]);
                const double size = measures.bounds.sizes().maxCoeff();
                const Vec3 place =
                    measures.bounds.center() + distance * size * Vec3(0.48, 0.64, 0.6);
                const auto changed = descriptor_of(kind.add(models[i], place, size));
                for (std::size_t r = 0; r < 3; ++r) {
                    const ranking::RankOptions options = {.ranker = ranking::kAllRankers[r]};
                    distances[i][r] =
                        ranking::rank_distances(changed, pointers, statistics, options)->at(i);
                }
            });
            std::array<double, 3> most = {};
            for (const auto& d : distances) {
                for (std::size_t r = 0; r < 3; ++r) most[r] = std::max(most[r], d[r]);
            }
            std::cout << fmt::format("{:<8} {:<7g} {:<7.4f} {:<9.4f} {:.4f}\n", kind.name, distance,
                                     most[0], most[1], most[2])
                      << std::flush;
        }
    }
}

}  // namespace

int main(int argc, char**) {
    const auto data = test::benchmark_data();
    if (!data || argc > 1) {
        std::cerr << "usage: ossuary_apart, with OSSUARY_DATA set to the folder of "
                     "princeton-segmentation/\n";
        return 2;
    }
    try {
        run(*data / "princeton-segmentation" / "off");
    } catch (const std::exception& error) {
        std::cerr << "ossuary_apart: " << error.what() << '\n';
        return 1;
    }
}
