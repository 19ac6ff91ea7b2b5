// How many of the exact ten nearest models a search of an index finds, by the width of its stages:
// the share that passes the scan of signatures and the sketches, and the time of a whole search
// with the default widths. Queries are models of the index, spread over it.
//   ossuary_recall INDEX [QUERIES [JOBS]]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <set>
#include <vector>

#include "engine/core/stopwatch.h"
#include "engine/ranking/near_search.h"
#include "engine/ranking/preselection.h"
#include "index/descriptor_cache.h"
#include "index/searcher.h"

namespace {

using namespace ossuary;
using ranking::RankedModel;

constexpr std::size_t kWanted = 10;
constexpr std::size_t kBlock = 1024;

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}
void unwrap(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().message);
}

/// Has one block in memory, so that all queries share what is decoded.
class BlockSource : public ranking::DescriptorSource {
public:
    explicit BlockSource(ranking::DescriptorSource& whole) : whole_(whole) {}
    [[nodiscard]] std::size_t size() const override { return whole_.size(); }
    void hold(std::vector<std::uint32_t> indices) {
        held_ = unwrap(whole_.fetch(indices));
        first_ = indices.front();
    }
    void let_go() { held_.clear(); }
    Result<std::vector<ranking::SharedDescriptor>> fetch(
        std::span<const std::uint32_t> indices) override {
        const bool all_held = std::ranges::all_of(indices, [&](std::uint32_t index) {
            return index >= first_ && index < first_ + held_.size();
        });
        if (!all_held) return whole_.fetch(indices);
        std::vector<ranking::SharedDescriptor> found;
        for (const std::uint32_t index : indices) found.push_back(held_[index - first_]);
        return found;
    }

private:
    ranking::DescriptorSource& whole_;
    std::vector<ranking::SharedDescriptor> held_;
    std::size_t first_ = 0;
};

struct Query {
    ranking::SharedDescriptor model;
    std::unique_ptr<ranking::NearSearch> search;
    std::vector<RankedModel> exact;
};

bool nearer(const RankedModel& a, const RankedModel& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
}

void keep(std::vector<RankedModel>& models, std::size_t count) {
    std::sort(models.begin(), models.end(), nearer);
    models.resize(std::min(count, models.size()));
}

void find_exact(std::vector<Query>& queries, BlockSource& source) {
    for (std::size_t begin = 0; begin < source.size(); begin += kBlock) {
        std::vector<std::uint32_t> indices;
        for (std::size_t i = begin; i < std::min(source.size(), begin + kBlock); ++i) {
            indices.push_back(static_cast<std::uint32_t>(i));
        }
        source.hold(indices);
        for (Query& query : queries) {
            std::vector<RankedModel> block;
            for (const std::uint32_t i : indices) block.push_back({i, 0.0});
            unwrap(query.search->measure(block));
            query.exact.insert(query.exact.end(), block.begin(), block.end());
            keep(query.exact, kWanted + 1);
        }
        if (begin / kBlock % 50 == 0) std::cerr << begin << " of " << source.size() << '\n';
    }
    source.let_go();
}

double share(const std::vector<RankedModel>& exact, const std::vector<RankedModel>& found) {
    std::set<std::size_t> there;
    for (const RankedModel& model : found) there.insert(model.index);
    const auto hits = std::count_if(exact.begin(), exact.end(), [&](const RankedModel& model) {
        return there.contains(model.index);
    });
    return static_cast<double>(hits) / static_cast<double>(exact.size());
}

template <typename Find>
void print_curve(const char* stage, const std::vector<Query>& queries,
                 const std::vector<std::size_t>& widths, const Find& find) {
    for (const std::size_t width : widths) {
        double sum = 0.0;
        for (const Query& query : queries) sum += share(query.exact, find(query, width));
        std::cout << fmt::format("{:<10} {:>6} {:.4f}\n", stage, width,
                                 sum / static_cast<double>(queries.size()));
    }
}

std::vector<RankedModel> by_signature(const ranking::Preselection& preselection, const Query& query,
                                      std::size_t width) {
    std::vector<RankedModel> models;
    for (const std::uint32_t index : preselection.nearest(query.model->signature, width)) {
        models.push_back({index, 0.0});
    }
    return models;
}

void run(const char* path, std::size_t count, int jobs) {
    auto searcher = unwrap(index::Searcher::open(path));
    const auto snapshot = unwrap(searcher.snapshot());
    index::DescriptorCache cache;
    index::SnapshotDescriptors whole(*snapshot, searcher.stores(), nullptr, jobs);
    index::SnapshotDescriptors cached(*snapshot, searcher.stores(), &cache, jobs);
    BlockSource source(whole);
    ranking::RankOptions options;
    options.jobs = jobs;
    std::vector<Query> queries(count);
    std::vector<std::uint32_t> places;
    for (std::size_t i = 0; i < count; ++i) {
        places.push_back(static_cast<std::uint32_t>((2 * i + 1) * snapshot->size() / (2 * count)));
    }
    const auto models = unwrap(whole.fetch(places));
    for (std::size_t i = 0; i < count; ++i) {
        queries[i].model = models[i];
        queries[i].search = std::make_unique<ranking::NearSearch>(
            *queries[i].model, source, snapshot->normalization(), options);
        unwrap(queries[i].search->judge_query(false));
    }
    find_exact(queries, source);
    for (std::size_t i = 0; i < count; ++i) {
        // Finding itself is no merit.
        std::erase_if(queries[i].exact,
                      [&](const RankedModel& model) { return model.index == places[i]; });
        keep(queries[i].exact, kWanted);
    }

    const auto widths = ranking::with_widths({}, snapshot->size());
    const auto& preselection = snapshot->preselection();
    std::cout << fmt::format("{} models, {} queries\n", snapshot->size(), count);
    print_curve("signature", queries, {500, 1000, 2000, 4000, 8000, 16000, 32000, 64000},
                [&](const Query& query, std::size_t width) {
                    return by_signature(preselection, query, width);
                });
    for (const std::size_t scanned : {widths.by_signature, 4 * widths.by_signature}) {
        std::vector<std::vector<RankedModel>> sketched;
        for (const Query& query : queries) {
            sketched.push_back(by_signature(preselection, query, scanned));
            query.search->sketch(sketched.back(), preselection);
            keep(sketched.back(), 1600);
        }
        const std::string name = fmt::format("sketch/{}", scanned);
        print_curve(name.c_str(), queries, {25, 50, 100, 150, 200, 300, 400, 800, 1600},
                    [&](const Query& query, std::size_t width) {
                        auto models_kept =
                            sketched[static_cast<std::size_t>(&query - queries.data())];
                        keep(models_kept, width);
                        return models_kept;
                    });
    }
    std::vector<double> times;
    print_curve("search", queries, {widths.by_sketch}, [&](const Query& query, std::size_t) {
        const Stopwatch watch;
        auto found = unwrap(ranking::nearest_models(*query.model, cached, preselection,
                                                    snapshot->normalization(), options,
                                                    {.count = kWanted + 1, .exhaustive_below = 0}));
        times.push_back(watch.elapsed_ms());
        return found;
    });
    std::sort(times.begin(), times.end());
    std::cout << fmt::format("search: {:.1f} ms in the median, {:.1f} at most\n",
                             times[times.size() / 2], times.back());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << "usage: ossuary_recall INDEX [QUERIES [JOBS]]\n";
        return 2;
    }
    try {
        run(argv[1], argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 50,
            argc > 3 ? std::atoi(argv[3]) : 0);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
