// The thesis' figures of retrieval (sec. 4.2) from its own ten classes of the Princeton
// segmentation benchmark, a command each:
//   ossuary_thesis_figures curves [THINNING]   Fig. 4.6: precision-recall of raw and refined
//                                              skeletons under `chain-code`
//   ossuary_thesis_figures codes [THINNING]    the lengths of chain codes of both
//   ossuary_thesis_figures poses               Table 4.2: armadillos among each other and against
//                                              other models, under `chain-code`, `skeleton`, and by
//                                              build and by pose alone
// THINNING is parallel, the thesis' own (default), or anchored.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/descriptor/body_scale.h"
#include "engine/descriptor/describe.h"
#include "engine/descriptor/solid_surface.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/ranker.h"
#include "engine/ranking/retrieval_metrics.h"
#include "engine/skeleton/refine.h"
#include "engine/skeleton/skeletonize.h"
#include "tests/support/benchmark_data.h"

namespace {

using namespace ossuary;
namespace fs = std::filesystem;

constexpr int kJobs = 2;

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

/// A way from the thinned skeleton to the one that is encoded.
struct Variant {
    const char* name;
    ossuary::skeleton::RefineOptions refine;
};

std::vector<Variant> variants() {
    ossuary::skeleton::RefineOptions raw;
    raw.pruning = ossuary::skeleton::PruningMethod::kNone;
    raw.merge_junctions = false;
    raw.smooth = false;
    ossuary::skeleton::RefineOptions thesis;
    thesis.pruning = ossuary::skeleton::PruningMethod::kSignificance;
    thesis.merge_junctions = false;
    return {{"raw thinning", raw},
            {"refined by eq. 3.3-3.4", thesis},
            {"refined by protrusion", ossuary::skeleton::RefineOptions{}}};
}

struct TenClasses {
    std::vector<ossuary::ranking::ClassifiedModel> models;
    std::vector<std::string> labels;
    fs::path folder;

    [[nodiscard]] ossuary::mesh::TriangleMesh mesh(std::size_t i) const {
        return unwrap(ossuary::mesh::read_mesh(folder / (models[i].id + ".off"))).mesh;
    }
};

TenClasses ten_classes(const fs::path& collection) {
    TenClasses classes;
    classes.models = ossuary::ranking::models_in_order(
        unwrap(ossuary::ranking::read_classification(collection / "segmentation-thesis10.cla")));
    for (const ossuary::ranking::ClassifiedModel& model : classes.models)
        classes.labels.push_back(model.class_name);
    classes.folder = collection / "off";
    return classes;
}

/// Of each variant the descriptors of all models; only their skeletons are filled in.
std::vector<std::vector<ossuary::descriptor::ModelDescriptor>> describe_variants(
    const TenClasses& classes, ossuary::skeleton::ThinningMethod thinning) {
    const std::vector<Variant> all = variants();
    std::vector<std::vector<ossuary::descriptor::ModelDescriptor>> described(
        all.size(), std::vector<ossuary::descriptor::ModelDescriptor>(classes.models.size()));
    ossuary::skeleton::SkeletonizeOptions options;
    options.thinning.method = thinning;
    parallel_for(classes.models.size(), kJobs, [&](std::size_t i) {
        const ossuary::mesh::TriangleMesh mesh = classes.mesh(i);
        const ossuary::skeleton::Skeleton skeleton =
            unwrap(ossuary::skeleton::skeletonize(mesh, options));
        std::vector<Vec3> surface;
        for (const Vec3& vertex : mesh.vertices) {
            surface.push_back(skeleton.solid.world_from_grid.grid(vertex));
        }
        const double scale = ossuary::descriptor::body_scale(
            ossuary::descriptor::solid_surface(skeleton.solid.volume).total_area,
            static_cast<double>(skeleton.solid.volume.count()));
        for (std::size_t v = 0; v < all.size(); ++v) {
            const ossuary::skeleton::SkeletonGraph graph =
                ossuary::skeleton::refine(skeleton.thinned, surface, all[v].refine).refined;
            described[v][i].skeleton = ossuary::matching::describe_skeleton(graph, scale);
        }
    });
    return described;
}

std::vector<const ossuary::descriptor::ModelDescriptor*> pointers(
    const std::vector<ossuary::descriptor::ModelDescriptor>& models) {
    std::vector<const ossuary::descriptor::ModelDescriptor*> all;
    for (const ossuary::descriptor::ModelDescriptor& model : models) all.push_back(&model);
    return all;
}

ossuary::ranking::RankOptions rank_options(ossuary::ranking::RankerKind ranker) {
    ossuary::ranking::RankOptions options;
    options.ranker = ranker;
    options.jobs = kJobs;
    return options;
}

void print_curves(const TenClasses& classes, ossuary::skeleton::ThinningMethod thinning) {
    const auto described = describe_variants(classes, thinning);
    std::vector<ossuary::ranking::RetrievalReport> reports;
    for (std::size_t v = 0; v < described.size(); ++v) {
        const ossuary::ranking::DistanceMatrix distances = *ossuary::ranking::distance_matrix(
            pointers(described[v]), {}, rank_options(ossuary::ranking::RankerKind::kChainCode));
        reports.push_back(ossuary::ranking::evaluate_retrieval(distances, classes.labels));
        const ossuary::ranking::RetrievalMetrics& mean = reports.back().mean;
        std::cout << fmt::format("{:<24} NN {:.3f} first tier {:.3f} DCG {:.3f} MAP {:.3f}\n",
                                 variants()[v].name, mean.nearest_neighbor, mean.first_tier,
                                 mean.dcg, mean.mean_average_precision);
    }
    std::cout << "recall";
    for (const Variant& variant : variants()) std::cout << fmt::format("  {:>22}", variant.name);
    std::cout << '\n';
    for (std::size_t point = 0; point < reports.front().precision_recall.size(); ++point) {
        std::cout << fmt::format("{:>6.2f}", reports.front().precision_recall[point].recall);
        for (const ossuary::ranking::RetrievalReport& report : reports) {
            std::cout << fmt::format("  {:>22.3f}", report.precision_recall[point].precision);
        }
        std::cout << '\n';
    }
}

void print_codes(const TenClasses& classes, ossuary::skeleton::ThinningMethod thinning) {
    const auto described = describe_variants(classes, thinning);
    double raw = 0.0;
    for (std::size_t v = 0; v < described.size(); ++v) {
        double length = 0.0, branches = 0.0;
        for (const ossuary::descriptor::ModelDescriptor& model : described[v]) {
            branches += static_cast<double>(model.skeleton.branches.size());
            for (const auto& branch : model.skeleton.branches) {
                length += static_cast<double>(branch.chain_code.size());
            }
        }
        const auto models = static_cast<double>(described[v].size());
        if (v == 0) raw = length;
        std::cout << fmt::format("{:<24} {:6.1f} digits and {:4.1f} branches a model, {:+.1f} %\n",
                                 variants()[v].name, length / models, branches / models,
                                 100.0 * (length / raw - 1.0));
    }
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// The chance that a pair of one pose against another is nearer than a pair with another model.
double area_under_curve(const std::vector<double>& within, std::vector<double> other) {
    std::sort(other.begin(), other.end());
    double sum = 0.0;
    for (const double distance : within) {
        const auto [first, last] = std::equal_range(other.begin(), other.end(), distance);
        sum += static_cast<double>(other.end() - last) + 0.5 * static_cast<double>(last - first);
    }
    return sum / (static_cast<double>(within.size()) * static_cast<double>(other.size()));
}

void print_poses(const TenClasses& classes) {
    std::vector<ossuary::descriptor::ModelDescriptor> models(classes.models.size());
    parallel_for(models.size(), kJobs, [&](std::size_t i) {
        models[i] = unwrap(ossuary::descriptor::describe(classes.mesh(i))).descriptor;
    });
    const auto collection = pointers(models);
    const ossuary::ranking::CollectionStatistics statistics =
        *ossuary::ranking::collection_statistics(collection, kJobs);
    struct Measure {
        std::string_view name;
        ossuary::ranking::RankerKind ranker;
        double pose;
    };
    using enum ossuary::ranking::RankerKind;
    for (const Measure& measure :
         {Measure{"chain-code", kChainCode, ossuary::ranking::kDefaultPose},
          Measure{"skeleton", kSkeleton, ossuary::ranking::kDefaultPose},
          Measure{"build", kSkeleton, 0.0}, Measure{"pose", kSkeleton, 1.0}}) {
        ossuary::ranking::RankOptions options = rank_options(measure.ranker);
        options.pose = measure.pose;
        const ossuary::ranking::DistanceMatrix distances =
            *ossuary::ranking::distance_matrix(collection, statistics, options);
        std::vector<double> within, other;
        for (std::size_t i = 0; i < models.size(); ++i) {
            if (classes.labels[i] != "armadillo") continue;
            for (std::size_t j = 0; j < models.size(); ++j) {
                if (j == i) continue;
                auto& kind = classes.labels[j] == "armadillo" ? within : other;
                kind.push_back(static_cast<double>(distances.at(i, j)));
            }
        }
        std::cout << fmt::format(
            "{:<11} poses {:.3f} to {:.3f}, median {:.3f}; other models from {:.3f}, median "
            "{:.3f}; ratio of medians {:.3f}; AUC {:.5f}\n",
            measure.name, *std::min_element(within.begin(), within.end()),
            *std::max_element(within.begin(), within.end()), median(within),
            *std::min_element(other.begin(), other.end()), median(other),
            median(within) / median(other), area_under_curve(within, other));
    }
}

int usage() {
    std::cerr << "usage: ossuary_thesis_figures curves|codes [parallel|anchored]\n"
                 "       ossuary_thesis_figures poses\n"
                 "with OSSUARY_DATA set to the folder of princeton-segmentation/\n";
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    const std::string figure = argc > 1 ? argv[1] : "";
    const Result<ossuary::skeleton::ThinningMethod> thinning =
        ossuary::skeleton::parse_thinning_method(argc > 2 ? argv[2] : "parallel");
    if (!data || argc > 3 || !thinning) return usage();
    try {
        const TenClasses classes = ten_classes(*data / "princeton-segmentation");
        if (figure == "curves") {
            print_curves(classes, *thinning);
        } else if (figure == "codes") {
            print_codes(classes, *thinning);
        } else if (figure == "poses" && argc == 2) {
            print_poses(classes);
        } else {
            return usage();
        }
    } catch (const std::exception& error) {
        std::cerr << "ossuary_thesis_figures: " << error.what() << '\n';
        return 1;
    }
}
