#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <random>

#include "engine/descriptor/describe.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/signature.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/preselection.h"
#include "tests/benchmarks/workload.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/random.h"

namespace ossuary::benchmarks {
namespace {

constexpr std::size_t kMaxOriginals = 380;
constexpr std::size_t kQueries = 10;

/// The segmentation benchmark's models, or the built workloads where it is not at hand.
std::vector<descriptor::ModelDescriptor> originals() {
    std::vector<descriptor::ModelDescriptor> models;
    if (const auto folder = test::benchmark_data()) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry :
             std::filesystem::directory_iterator(*folder / "princeton-segmentation" / "off")) {
            files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
        for (std::size_t i = 0; i < std::min(files.size(), kMaxOriginals); ++i) {
            const auto mesh = mesh::read_mesh(files[i]);
            if (mesh) models.push_back(descriptor::describe(mesh->mesh)->descriptor);
        }
    }
    for (std::size_t i = 0; models.empty() && i < workloads().size(); ++i) {
        models.push_back(descriptor::describe(workloads()[i].mesh)->descriptor);
    }
    return models;
}

/// A number of about unit variance around 0.
double noise(std::mt19937_64& random) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += 2.0 * test::next_unit(random) - 1.0;
    return sum;
}

/// Another model of the same build: limbs of other lengths and radii, other global descriptors.
descriptor::ModelDescriptor perturbed(const descriptor::ModelDescriptor& original,
                                      std::uint64_t seed) {
    std::mt19937_64 random(seed);
    descriptor::ModelDescriptor model = original;
    for (matching::SkeletonDescriptor::Branch& branch : model.skeleton.branches) {
        const auto longer = static_cast<float>(std::exp(0.1 * noise(random)));
        const auto thicker = static_cast<float>(std::exp(0.1 * noise(random)));
        branch.length *= longer;
        for (float& radius : branch.radii) radius *= thicker;
    }
    matching::derive_matching_data(model.skeleton);
    for (descriptor::GlobalDescriptor& global : model.globals) {
        for (std::uint8_t& value : global.values) {
            const double changed = value * std::exp(0.1 * noise(random)) + 0.5 * noise(random);
            value = static_cast<std::uint8_t>(std::clamp(std::round(changed), 0.0, 255.0));
        }
    }
    model.signature = descriptor::preselection_signature(model.skeleton, model.globals);
    return model;
}

struct Collection {
    std::vector<descriptor::ModelDescriptor> models;
    std::vector<descriptor::ModelDescriptor> queries;
    std::vector<const descriptor::ModelDescriptor*> pointers;
    ranking::ScanRows rows;
    ranking::Preselection preselection;
    ranking::Normalization normalization;

    [[nodiscard]] std::vector<ranking::RankedModel> nearest(
        const descriptor::ModelDescriptor& query,
        const ranking::NearestOptions& options = {}) const {
        ranking::DescriptorsInMemory source(pointers);
        return *ranking::nearest_models(query, source, preselection, normalization, {}, options);
    }
};

/// Made once for each size; a hundred thousand models take a minute and two gigabytes.
const Collection& collection_of(std::size_t size) {
    static const std::vector<descriptor::ModelDescriptor> kOriginals = originals();
    static std::map<std::size_t, Collection> known;
    Collection& collection = known[size];
    if (!collection.models.empty()) return collection;
    for (std::size_t i = 0; i < size; ++i) {
        collection.models.push_back(perturbed(kOriginals[i % kOriginals.size()], i));
    }
    for (std::size_t i = 0; i < kQueries; ++i) {
        collection.queries.push_back(perturbed(kOriginals[(i * 37) % kOriginals.size()], size + i));
    }
    for (const descriptor::ModelDescriptor& model : collection.models)
        collection.pointers.push_back(&model);
    for (const descriptor::ModelDescriptor* model : collection.pointers) {
        collection.rows.append(*model);
    }
    collection.preselection = ranking::Preselection({&collection.rows});
    collection.normalization =
        ranking::Normalization(*ranking::collection_statistics(collection.pointers));
    return collection;
}

/// The share of the exact ten nearest that the preselection finds.
double recall(const Collection& collection) {
    std::size_t found = 0, wanted = 0;
    for (const descriptor::ModelDescriptor& query : collection.queries) {
        const auto quick = collection.nearest(query);
        ranking::NearestOptions exhaustive;
        exhaustive.exhaustive_below = collection.models.size();
        const auto exact = collection.nearest(query, exhaustive);
        for (const ranking::RankedModel& model : exact) {
            ++wanted;
            found += std::any_of(
                quick.begin(), quick.end(),
                [&](const ranking::RankedModel& other) { return other.index == model.index; });
        }
    }
    return static_cast<double>(found) / static_cast<double>(wanted);
}

void time_search(benchmark::State& state, std::size_t size) {
    const Collection& collection = collection_of(size);
    std::size_t query = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(collection.nearest(collection.queries[query++ % kQueries]));
    }
    state.counters["recall_at_10"] = recall(collection);
}

}  // namespace

void register_search_benchmarks() {
    for (const std::size_t size : {380UL, 10'000UL, 100'000UL}) {
        benchmark::RegisterBenchmark(("nearest_models/" + std::to_string(size)).c_str(),
                                     [size](benchmark::State& state) { time_search(state, size); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(kQueries);
    }
}

}  // namespace ossuary::benchmarks
