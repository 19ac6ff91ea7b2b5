// How often a piece that was cut from a model finds it: from each model of the Princeton
// segmentation benchmark one part by a human segmentation, of 8 to 40 % of the area, as an open
// mesh and with its hole closed, turned and scaled at random. Which half of the models pieces are
// cut from is the caller's choice, so that one half stays out of tuning.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"
#include "engine/registration/piece_search.h"
#include "index/searcher.h"
#include "tests/benchmarks/cut_pieces.h"
#include "tests/support/benchmark_data.h"

namespace {

using namespace ossuary;
namespace fs = std::filesystem;

constexpr std::size_t kFirst = 10;
/// Models of the benchmark that are the same file.
const std::map<std::string, std::string> kDoubles{
    {"226", "227"}, {"227", "226"}, {"243", "251"}, {"251", "243"}};

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

struct Figures {
    std::size_t queries = 0, first = 0, among_ten = 0;
    double precision = 0.0;  ///< sum, of the first ten other models

    void add(const std::vector<std::string>& names, const std::string& source,
             const std::map<std::string, std::string>& classes) {
        ++queries;
        const auto is_source = [&](const std::string& name) {
            const auto twin = kDoubles.find(source);
            return name == source || (twin != kDoubles.end() && name == twin->second);
        };
        std::size_t others = 0;
        std::size_t alike = 0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (is_source(names[i])) {
                first += i == 0 ? 1 : 0;
                among_ten += i < kFirst ? 1 : 0;
            } else if (others < kFirst) {
                ++others;
                const auto found = classes.find(names[i]);
                alike += found != classes.end() && found->second == classes.at(source) ? 1 : 0;
            }
        }
        precision += static_cast<double>(alike) / static_cast<double>(kFirst);
    }
    void print(const std::string& what) const {
        const auto count = static_cast<double>(std::max<std::size_t>(1, queries));
        std::cout << fmt::format("{:<24} {:>4} {:>6.2f} {:>6.2f} {:>6.2f}\n", what, queries,
                                 static_cast<double>(first) / count,
                                 static_cast<double>(among_ten) / count, precision / count);
    }
};

std::map<std::string, std::string> classes_of(const fs::path& file) {
    std::map<std::string, std::string> classes;
    for (const auto& model :
         ossuary::ranking::models_in_order(unwrap(ossuary::ranking::read_classification(file)))) {
        classes[model.id] = model.class_name;
    }
    return classes;
}

std::vector<std::string> names_of(const index::SearchResult& result) {
    std::vector<std::string> names;
    for (const index::Hit& hit : result.hits) names.push_back(hit.name);
    return names;
}

using Report = std::map<std::string, Figures>;

/// Looks for one piece, with its surface and by its skeleton alone, as it is and with its hole
/// closed; returns the milliseconds of the searches with the surface.
std::vector<double> look_for(index::Searcher& searcher, const ossuary::mesh::TriangleMesh& piece,
                             const std::string& source, std::uint64_t seed,
                             const std::map<std::string, std::string>& classes, Report& report) {
    std::vector<double> took_ms;
    for (const bool closed : {false, true}) {
        const ossuary::mesh::TriangleMesh query = benchmarks::moved_at_random(
            closed ? benchmarks::with_holes_closed(piece) : piece, seed);
        const auto described = searcher.describe(query);
        if (!described) continue;
        index::SearchOptions options;
        options.rank.part = true;
        options.rank.jobs = 0;
        options.limit = 0;
        options.with_match = false;
        const auto features = ossuary::registration::piece_query(described->body.of(query));
        const auto found = unwrap(searcher.nearest(*described, options, {}, &features));
        took_ms.push_back(found.took_ms);
        const std::string kind = closed ? "closed" : "open";
        report[kind].add(names_of(found), source, classes);
        const auto before = unwrap(searcher.nearest(*described, options));
        report[kind + ", skeletons alone"].add(names_of(before), source, classes);
    }
    return took_ms;
}

void run(const fs::path& collection, const fs::path& index_path, bool held_out, int every) {
    index::Searcher searcher = unwrap(index::Searcher::open(index_path));
    const auto classes = classes_of(collection / "segmentation-all.cla");
    Report report;
    std::vector<double> took_ms;
    int taken = 0;
    for (const auto& [name, class_name] : classes) {
        const int number = std::stoi(name);
        if ((number % 2 == 0) != held_out || taken++ % every != 0) continue;
        const ossuary::mesh::TriangleMesh mesh =
            unwrap(ossuary::mesh::read_mesh(collection / "off" / (name + ".off"))).mesh;
        const auto seed = static_cast<std::uint64_t>(number);
        const auto piece = benchmarks::cut_piece(mesh, collection / "seg", name, seed);
        if (!piece) continue;
        for (const double ms : look_for(searcher, piece->mesh, name, seed, classes, report)) {
            took_ms.push_back(ms);
        }
    }
    std::cout << fmt::format("{:<24} {:>4} {:>6} {:>6} {:>6}\n", held_out ? "held out" : "tuning",
                             "n", "first", "ten", "P@10");
    for (const auto& [kind, figures] : report) figures.print(kind);
    std::sort(took_ms.begin(), took_ms.end());
    const double median = took_ms.empty() ? 0.0 : took_ms[took_ms.size() / 2];
    std::cout << fmt::format("{} models, {:.0f} ms a search in the median\n",
                             unwrap(searcher.snapshot())->size(), median);
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    const std::string half = argc > 2 ? argv[2] : "";
    if (!data || argc < 3 || argc > 4 || (half != "tuning" && half != "held-out")) {
        std::cerr << "usage: ossuary_pieces INDEX tuning|held-out [EVERY], an index of the "
                     "segmentation benchmark; OSSUARY_DATA is the folder of "
                     "princeton-segmentation/\n";
        return 2;
    }
    try {
        const int every = argc == 4 ? std::max(1, std::atoi(argv[3])) : 1;
        run(*data / "princeton-segmentation", argv[1], half == "held-out", every);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_pieces: " << error.what() << '\n';
        return 1;
    }
}
