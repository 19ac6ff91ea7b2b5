// How often a limb finds models of the class that it was cut from: from five models of each class
// of the Princeton segmentation benchmark the largest part by a human segmentation is taken away,
// and the up to two largest limbs that are left are searched for among all 380, the model itself
// left out, by partial matching and as if they were whole models.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "engine/decomposition/seg_file.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/disjoint_sets.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/part_search.h"
#include "engine/ranking/ranker.h"
#include "index/evaluation.h"
#include "index/searcher.h"
#include "tests/benchmarks/cut_pieces.h"
#include "tests/support/benchmark_data.h"

namespace {

using namespace ossuary;
namespace fs = std::filesystem;

constexpr std::size_t kFirst = 10;
constexpr std::size_t kEvery = 4;  // of the models of a class
constexpr double kSmallestLimb = 0.04;
constexpr std::size_t kLimbs = 2;

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

double area_of(const ossuary::mesh::TriangleMesh& mesh, std::size_t face) {
    const auto& [a, b, c] = mesh.triangles[face];
    const Vec3 u = mesh.vertices[b] - mesh.vertices[a];
    return 0.5 * u.cross(mesh.vertices[c] - mesh.vertices[a]).norm();
}

/// What hangs together once the part with the greatest area is gone, the largest limbs first.
std::vector<ossuary::mesh::TriangleMesh> limbs_of(
    const ossuary::mesh::TriangleMesh& mesh,
    const ossuary::decomposition::Segmentation& segmentation) {
    std::map<std::uint32_t, double> areas;
    double total = 0.0;
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
        areas[segmentation.labels[face]] += area_of(mesh, face);
        total += area_of(mesh, face);
    }
    const auto largest =
        std::max_element(areas.begin(), areas.end(),
                         [](const auto& x, const auto& y) { return x.second < y.second; });
    ossuary::mesh::DisjointSets sets(mesh.vertices.size());
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
        if (segmentation.labels[face] == largest->first) continue;
        sets.unite(mesh.triangles[face][0], mesh.triangles[face][1]);
        sets.unite(mesh.triangles[face][0], mesh.triangles[face][2]);
    }
    struct Limb {
        double area = 0.0;
        std::vector<std::size_t> faces;
    };
    std::map<std::uint32_t, Limb> limbs;
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
        if (segmentation.labels[face] == largest->first) continue;
        Limb& limb = limbs[sets.find(mesh.triangles[face][0])];
        limb.area += area_of(mesh, face);
        limb.faces.push_back(face);
    }
    std::vector<Limb> sorted;
    for (auto& [root, limb] : limbs) {
        if (limb.area >= kSmallestLimb * total) sorted.push_back(std::move(limb));
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Limb& x, const Limb& y) { return x.area > y.area; });
    std::vector<ossuary::mesh::TriangleMesh> meshes;
    for (std::size_t i = 0; i < std::min(kLimbs, sorted.size()); ++i) {
        meshes.push_back(benchmarks::cut_out(mesh, sorted[i].faces));
    }
    return meshes;
}

/// Of the first ten models, the source left out, how many are of its class.
std::size_t found_in_first(const std::vector<double>& distances,
                           const std::vector<std::string>& labels, std::size_t source) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        if (i != source) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t x, std::size_t y) { return distances[x] < distances[y]; });
    std::size_t found = 0;
    for (std::size_t i = 0; i < kFirst; ++i) {
        if (labels[order[i]] == labels[source]) ++found;
    }
    return found;
}

struct Outcome {
    std::size_t queries = 0;
    std::size_t as_part = 0;
    std::size_t as_whole = 0;
};

void print(const std::string& name, const Outcome& outcome) {
    const auto hits = static_cast<double>(kFirst * std::max<std::size_t>(outcome.queries, 1));
    std::cout << fmt::format("{:<12} {:>4} {:>6.2f} {:>6.2f}\n", name, outcome.queries,
                             static_cast<double>(outcome.as_part) / hits,
                             static_cast<double>(outcome.as_whole) / hits);
}

void run(const fs::path& collection, const fs::path& index_path) {
    index::Searcher searcher = unwrap(index::Searcher::open(index_path));
    const auto snapshot = unwrap(searcher.snapshot());
    std::vector<std::string> labels;
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < snapshot->size(); ++i) {
        labels.emplace_back(snapshot->class_name(i));
        positions.push_back(i);
    }
    const auto loaded = unwrap(index::load_descriptors(*snapshot, searcher.stores(), positions, 0));
    std::vector<const ossuary::descriptor::ModelDescriptor*> models;
    for (const auto& model : loaded) models.push_back(model.get());
    std::map<std::string, std::size_t> seen;
    std::map<std::string, Outcome> outcomes;
    Outcome all;
    for (std::size_t i = 0; i < snapshot->size(); ++i) {
        const std::string name = unwrap(searcher.store().model(snapshot->id(i))).name;
        if (labels[i].empty() || seen[labels[i]]++ % kEvery != 0) continue;
        const ossuary::mesh::TriangleMesh mesh =
            unwrap(ossuary::mesh::read_mesh(collection / "off" / (name + ".off"))).mesh;
        const auto segmentations = unwrap(ossuary::decomposition::read_segmentations(
            collection / "seg", name, mesh.triangles.size()));
        if (segmentations.empty()) continue;
        for (const ossuary::mesh::TriangleMesh& limb : limbs_of(mesh, segmentations.front())) {
            const ossuary::descriptor::ModelDescriptor query =
                unwrap(ossuary::descriptor::describe(limb)).descriptor;
            const auto as_part = *ossuary::ranking::part_distances(query, models, {});
            const auto as_whole =
                *ossuary::ranking::rank_distances(query, models, snapshot->statistics());
            for (Outcome* outcome : {&outcomes[labels[i]], &all}) {
                ++outcome->queries;
                outcome->as_part += found_in_first(as_part, labels, i);
                outcome->as_whole += found_in_first(as_whole, labels, i);
            }
        }
    }
    std::cout << fmt::format("{:<12} {:>4} {:>6} {:>6}\n", "class", "n", "part", "whole");
    for (const auto& [name, outcome] : outcomes) print(name, outcome);
    print("all", all);
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    if (!data || argc != 2) {
        std::cerr << "usage: ossuary_parts INDEX, an index of the segmentation benchmark with its "
                     "classes, and OSSUARY_DATA set to the folder of princeton-segmentation/\n";
        return 2;
    }
    try {
        run(*data / "princeton-segmentation", argv[1]);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_parts: " << error.what() << '\n';
        return 1;
    }
}
