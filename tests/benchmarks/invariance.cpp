// How often a changed copy of a model finds its original as the first hit: 100 models of the
// Princeton segmentation benchmark as copies that are turned at random, have vertex noise of 0.2 %
// of the bounding box' diagonal, are decimated to 30 % of their faces, mirrored, or scaled and
// renumbered, each searched for among all 380 originals. With rounds to run, each but the first has
// other models and other random numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/ranker.h"
#include "tests/support/benchmark_data.h"

namespace {

using namespace ossuary;
using Random = std::mt19937_64;

constexpr std::size_t kCopies = 100;

void turn(ossuary::mesh::TriangleMesh& mesh, Random& random) {
    std::normal_distribution<double> normal;
    Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    const Mat3 rotation = q.normalized().toRotationMatrix();
    for (Vec3& vertex : mesh.vertices) vertex = rotation * vertex;
}

void add_noise(ossuary::mesh::TriangleMesh& mesh, Random& random) {
    std::normal_distribution<double> normal(0.0, 0.002 * ossuary::mesh::measure(mesh).diagonal);
    for (Vec3& vertex : mesh.vertices) {
        vertex += Vec3(normal(random), normal(random), normal(random));
    }
}

void decimate_to_30_percent(ossuary::mesh::TriangleMesh& mesh, Random&) {
    ossuary::mesh::DecimateOptions options;
    options.max_triangles = mesh.triangles.size() * 3 / 10;
    mesh = ossuary::mesh::decimate(mesh, options);
}

void mirror(ossuary::mesh::TriangleMesh& mesh, Random&) {
    for (Vec3& vertex : mesh.vertices) vertex.x() = -vertex.x();
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

void scale_and_renumber(ossuary::mesh::TriangleMesh& mesh, Random& random) {
    std::vector<std::uint32_t> place(mesh.vertices.size());
    for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
    std::shuffle(place.begin(), place.end(), random);
    std::vector<Vec3> vertices(mesh.vertices.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        vertices[place[i]] = 2.7 * mesh.vertices[i] + Vec3(3, 4, 5);
    }
    mesh.vertices = std::move(vertices);
    for (auto& triangle : mesh.triangles) {
        for (auto& vertex : triangle) vertex = place[vertex];
    }
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
}

struct Change {
    const char* name;
    void (*apply)(ossuary::mesh::TriangleMesh&, Random&);
};
constexpr Change kChanges[] = {{"turned", turn},
                               {"noise", add_noise},
                               {"decimated", decimate_to_30_percent},
                               {"mirrored", mirror},
                               {"scaled", scale_and_renumber}};

ossuary::mesh::TriangleMesh read(const std::filesystem::path& folder, const std::string& id) {
    Result<ossuary::mesh::ReadMeshResult> read = ossuary::mesh::read_mesh(folder / (id + ".off"));
    if (!read) throw std::runtime_error(read.error().message);
    return std::move(read->mesh);
}

ossuary::descriptor::ModelDescriptor describe_mesh(const ossuary::mesh::TriangleMesh& mesh) {
    Result<ossuary::descriptor::Description> description = ossuary::descriptor::describe(mesh);
    if (!description) throw std::runtime_error(description.error().message);
    return std::move(description->descriptor);
}

/// Models nearer to a copy than its original is; exact duplicates of the original are not nearer.
std::size_t models_before(const std::vector<double>& distances, std::size_t original) {
    return static_cast<std::size_t>(
        std::count_if(distances.begin(), distances.end(),
                      [&](double distance) { return distance < distances[original]; }));
}

void run(const std::filesystem::path& collection, const ossuary::ranking::RankOptions& options,
         int rounds) {
    const auto classes = ossuary::ranking::read_classification(collection / "segmentation-all.cla");
    if (!classes) throw std::runtime_error(classes.error().message);
    const auto models = ossuary::ranking::models_in_order(*classes);
    std::vector<ossuary::descriptor::ModelDescriptor> originals(models.size());
    parallel_for(models.size(), options.jobs, [&](std::size_t i) {
        originals[i] = describe_mesh(read(collection / "off", models[i].id));
    });
    std::vector<const ossuary::descriptor::ModelDescriptor*> pointers;
    for (const ossuary::descriptor::ModelDescriptor& original : originals)
        pointers.push_back(&original);
    const auto statistics = *ossuary::ranking::collection_statistics(pointers, options.jobs);
    ossuary::ranking::RankOptions one_thread = options;
    one_thread.jobs = 1;
    const std::size_t copies = kCopies * static_cast<std::size_t>(rounds);
    for (const Change& change : kChanges) {
        std::vector<std::size_t> before(copies);
        parallel_for(copies, options.jobs, [&](std::size_t copy) {
            const std::size_t round = copy / kCopies;
            const std::size_t original =
                (copy % kCopies * models.size() / kCopies + round) % models.size();
            Random random(copy);
            ossuary::mesh::TriangleMesh mesh = read(collection / "off", models[original].id);
            change.apply(mesh, random);
            before[copy] = models_before(*ossuary::ranking::rank_distances(
                                             describe_mesh(mesh), pointers, statistics, one_thread),
                                         original);
        });
        const auto first = std::count(before.begin(), before.end(), std::size_t{0});
        std::cout << fmt::format("{:<10} {:>4} of {} first\n", change.name, first, copies)
                  << std::flush;
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    const Result<ossuary::ranking::RankerKind> ranker =
        ossuary::ranking::parse_ranker(argc > 1 ? argv[1] : "skeleton");
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 1;
    if (!data || !ranker || rounds < 1 || argc > 3) {
        std::cerr << "usage: ossuary_invariance [RANKER [ROUNDS]], with OSSUARY_DATA set to the "
                     "folder of princeton-segmentation/\n";
        return 2;
    }
    ossuary::ranking::RankOptions options;
    options.ranker = *ranker;
    options.jobs = 2;
    try {
        run(*data / "princeton-segmentation", options, rounds);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_invariance: " << error.what() << '\n';
        return 1;
    }
}
