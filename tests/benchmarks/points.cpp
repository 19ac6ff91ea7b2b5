// How often models of the thesis' ten classes are found again by points alone: 5,000 points of the
// surface of each, drawn at random over its area, with noise of 0.2 % of the bounding box'
// diagonal, written as text, read back and searched for among the models themselves. With the share
// of the solid that the wrapped surface has in common with the model's, and the time of wrapping.
//   ossuary_points [RANKER [POINTS [STEP]]]   every STEP-th model is a query
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/core/stopwatch.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/sample_surface.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/ranker.h"
#include "engine/voxel/read_model.h"
#include "tests/support/benchmark_data.h"

namespace {

using namespace ossuary;

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

std::string sampled(const mesh::TriangleMesh& model, std::size_t count, std::uint64_t seed) {
    mesh::SampleSurfaceOptions options;
    options.count = count;
    options.seed = seed;
    options.stratified = false;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 0.002 * mesh::measure(model).diagonal);
    std::string text;
    for (const mesh::SurfaceSample& sample : mesh::sample_surface(model, options)) {
        const Vec3 at = sample.point + Vec3(normal(random), normal(random), normal(random));
        text += fmt::format("{:.9g} {:.9g} {:.9g}\n", at.x(), at.y(), at.z());
    }
    return text;
}

struct Outcome {
    std::size_t before = 0;  ///< models nearer than the one that was sampled
    double first_tier = 0.0;
    double volume_ratio = 0.0;
    double wrap_ms = 0.0;
    std::size_t triangles = 0;
};

double first_tier(const std::vector<double>& distances, const std::vector<std::string>& labels,
                  std::size_t query) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        if (i != query) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
    const auto in_class =
        static_cast<std::size_t>(std::count(labels.begin(), labels.end(), labels[query])) - 1;
    std::size_t found = 0;
    for (std::size_t i = 0; i < in_class; ++i) found += labels[order[i]] == labels[query] ? 1 : 0;
    return static_cast<double>(found) / static_cast<double>(in_class);
}

void run(const std::filesystem::path& collection, ranking::RankOptions options, std::size_t count,
         std::size_t step) {
    const auto models = ranking::models_in_order(
        unwrap(ranking::read_classification(collection / "segmentation-thesis10.cla")));
    std::vector<mesh::TriangleMesh> meshes(models.size());
    std::vector<descriptor::ModelDescriptor> originals(models.size());
    std::vector<const descriptor::ModelDescriptor*> pointers(models.size());
    std::vector<std::string> labels;
    for (const auto& model : models) labels.push_back(model.class_name);
    parallel_for(models.size(), options.jobs, [&](std::size_t i) {
        meshes[i] = unwrap(voxel::read_model(collection / "off" / (models[i].id + ".off"))).mesh;
        originals[i] = unwrap(descriptor::describe(meshes[i])).descriptor;
        pointers[i] = &originals[i];
    });
    const auto statistics = unwrap(ranking::collection_statistics(pointers, options.jobs));
    const int jobs = std::exchange(options.jobs, 1);
    std::vector<Outcome> outcomes((models.size() + step - 1) / step);
    parallel_for(outcomes.size(), jobs, [&](std::size_t q) {
        const std::size_t model = q * step;
        const std::string text = sampled(meshes[model], count, model);
        Outcome& outcome = outcomes[q];
        Stopwatch watch;
        const auto read = unwrap(voxel::read_model(text, models[model].id));
        outcome.wrap_ms = watch.lap_ms();
        outcome.triangles = read.mesh.triangles.size();
        outcome.volume_ratio =
            mesh::measure(read.mesh).signed_volume / mesh::measure(meshes[model]).signed_volume;
        const auto described = unwrap(descriptor::describe(read.mesh));
        const auto distances =
            unwrap(ranking::rank_distances(described.descriptor, pointers, statistics, options));
        outcome.before = static_cast<std::size_t>(
            std::count_if(distances.begin(), distances.end(),
                          [&](double distance) { return distance < distances[model]; }));
        outcome.first_tier = first_tier(distances, labels, model);
    });
    for (std::size_t q = 0; q < outcomes.size(); ++q) {
        if (outcomes[q].before == 0) continue;
        std::cout << fmt::format("{}: {} before it, volume {:.3f}\n", models[q * step].id,
                                 outcomes[q].before, outcomes[q].volume_ratio);
    }
    std::map<std::string, std::vector<Outcome>> by_class;
    for (std::size_t q = 0; q < outcomes.size(); ++q) {
        by_class[labels[q * step]].push_back(outcomes[q]);
    }
    by_class["all"] = outcomes;
    std::cout << fmt::format("{:<14} {:>6} {:>6} {:>10} {:>7} {:>9} {:>8}\n", "class", "models",
                             "first", "first tier", "volume", "triangles", "wrap ms");
    for (const auto& [name, of_class] : by_class) {
        Outcome sum;
        std::size_t first = 0;
        for (const Outcome& outcome : of_class) {
            first += outcome.before == 0 ? 1 : 0;
            sum.first_tier += outcome.first_tier;
            sum.volume_ratio += outcome.volume_ratio;
            sum.wrap_ms += outcome.wrap_ms;
            sum.triangles += outcome.triangles;
        }
        const auto n = static_cast<double>(of_class.size());
        std::cout << fmt::format("{:<14} {:>6} {:>6.3f} {:>10.3f} {:>7.3f} {:>9.0f} {:>8.0f}\n",
                                 name, of_class.size(), static_cast<double>(first) / n,
                                 sum.first_tier / n, sum.volume_ratio / n,
                                 static_cast<double>(sum.triangles) / n, sum.wrap_ms / n);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    const auto ranker = ranking::parse_ranker(argc > 1 ? argv[1] : "hybrid");
    const int count = argc > 2 ? std::atoi(argv[2]) : 5000;
    const int step = argc > 3 ? std::atoi(argv[3]) : 1;
    if (!data || !ranker || count < 1 || step < 1 || argc > 4) {
        std::cerr << "usage: ossuary_points [RANKER [POINTS [STEP]]], with OSSUARY_DATA set to the "
                     "folder of princeton-segmentation/\n";
        return 2;
    }
    ranking::RankOptions options;
    options.ranker = *ranker;
    options.jobs = 2;
    try {
        run(*data / "princeton-segmentation", options, static_cast<std::size_t>(count),
            static_cast<std::size_t>(step));
    } catch (const std::exception& error) {
        std::cerr << "ossuary_points: " << error.what() << '\n';
        return 1;
    }
}
