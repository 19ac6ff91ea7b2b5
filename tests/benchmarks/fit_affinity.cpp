// Fits the weights of engine/decomposition/affinity.cpp to people's segmentations and prints them:
//   ossuary_fit_affinity CLASSES.cla MODELS_DIR TRUTH_DIR
// Logistic regression of the share of people who put two patches into one part, every pair weighted
// by its pairs of triangles, every model alike; Newton's method, so that the outcome is the optimum
// and does not depend on any order or chance.

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "engine/decomposition/decompose.h"
#include "engine/decomposition/pair_features.h"
#include "engine/decomposition/seg_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/ranking/classification.h"

namespace {

using namespace ossuary;
namespace fs = std::filesystem;

constexpr Eigen::Index kUnknowns =
    static_cast<Eigen::Index>(ossuary::decomposition::kPairFeatureCount) + 1;
constexpr double kRidge = 1e-4;  // on standardized features
using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

struct Example {
    ossuary::decomposition::PatchPairs pairs;
    std::vector<double> together;  ///< share of people
    std::vector<double> weights;   ///< sum 1
};

/// For each patch the share of its triangles in each part of a segmentation.
std::vector<std::vector<double>> shares(const ossuary::decomposition::PatchGraph& graph,
                                        const ossuary::decomposition::Segmentation& truth) {
    std::vector<std::vector<double>> share(graph.size(), std::vector<double>(truth.parts, 0.0));
    for (std::size_t t = 0; t < truth.labels.size(); ++t) {
        const std::uint32_t patch = graph.of_triangle[t];
        share[patch][truth.labels[t]] += 1.0 / graph.patches[patch].triangles;
    }
    return share;
}

std::optional<Example> example_of(const fs::path& models, const fs::path& truth_folder,
                                  const std::string& id) {
    const auto read = ossuary::mesh::read_mesh(models / (id + ".off"));
    if (!read.ok()) return std::nullopt;
    const auto truths =
        ossuary::decomposition::read_segmentations(truth_folder, id, read->mesh.triangles.size());
    if (!truths.ok() || truths->empty()) return std::nullopt;
    const auto patches =
        ossuary::decomposition::measure_patches(ossuary::mesh::mend_surface(read->mesh));
    if (!patches.ok()) return std::nullopt;
    Example example;
    example.pairs = patches->pairs;
    example.together.assign(example.pairs.features.size(), 0.0);
    double total = 0.0;
    for (const ossuary::decomposition::Segmentation& truth : *truths) {
        const auto share = shares(patches->graph, truth);
        for (std::size_t j = 1; j < patches->graph.size(); ++j) {
            for (std::size_t i = 0; i < j; ++i) {
                double same = 0.0;
                for (std::size_t l = 0; l < truth.parts; ++l) same += share[i][l] * share[j][l];
                example.together[ossuary::decomposition::PatchPairs::index(i, j)] +=
                    same / static_cast<double>(truths->size());
            }
        }
    }
    for (std::size_t j = 1; j < patches->graph.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            example.weights.push_back(static_cast<double>(patches->graph.patches[i].triangles) *
                                      patches->graph.patches[j].triangles);
            total += example.weights.back();
        }
    }
    for (double& weight : example.weights) weight /= total;
    return example;
}

Vector unknowns_of(const ossuary::decomposition::PairFeatures& features) {
    Vector x;
    for (std::size_t k = 0; k < ossuary::decomposition::kPairFeatureCount; ++k) {
        x[static_cast<Eigen::Index>(k)] = static_cast<double>(features[k]);
    }
    x[kUnknowns - 1] = 1.0;
    return x;
}

/// Mean and standard deviation of each feature; 0 and 1 for the constant.
std::pair<Vector, Vector> moments(const std::vector<Example>& examples) {
    Vector sum = Vector::Zero(), squares = Vector::Zero();
    double total = 0.0;
    for (const Example& example : examples) {
        for (std::size_t p = 0; p < example.weights.size(); ++p) {
            const Vector x = unknowns_of(example.pairs.features[p]);
            sum += example.weights[p] * x;
            squares += example.weights[p] * x.cwiseProduct(x);
            total += example.weights[p];
        }
    }
    Vector mean = sum / total;
    Vector deviation = (squares / total - mean.cwiseProduct(mean)).cwiseMax(1e-12).cwiseSqrt();
    mean[kUnknowns - 1] = 0.0;
    deviation[kUnknowns - 1] = 1.0;
    return {mean, deviation};
}

Vector fit(const std::vector<Example>& examples, const Vector& mean, const Vector& deviation) {
    Vector weights = Vector::Zero();
    for (int round = 0; round < 12; ++round) {
        Matrix curvature = kRidge * Matrix::Identity();
        Vector slope = -kRidge * weights;
        const auto scale = 1.0 / static_cast<double>(examples.size());
        for (const Example& example : examples) {
            for (std::size_t p = 0; p < example.weights.size(); ++p) {
                const Vector x =
                    (unknowns_of(example.pairs.features[p]) - mean).cwiseQuotient(deviation);
                const double q = 1.0 / (1.0 + std::exp(-weights.dot(x)));
                const double w = example.weights[p] * scale;
                slope += w * (example.together[p] - q) * x;
                curvature.selfadjointView<Eigen::Lower>().rankUpdate(x, w * q * (1.0 - q));
            }
        }
        const Vector step = curvature.selfadjointView<Eigen::Lower>().llt().solve(slope);
        weights += step;
        std::cerr << fmt::format("round {}: largest step {:.2e}\n", round,
                                 step.cwiseAbs().maxCoeff());
        if (step.cwiseAbs().maxCoeff() < 1e-6) break;
    }
    return weights;
}

/// As engine/decomposition/affinity.cpp writes them.
using enum ossuary::decomposition::PairFeature;
constexpr ossuary::decomposition::OfPairFeatures<std::string_view> kNames = {{
    {kThicknessLeast, "kThicknessLeast"},
    {kThicknessMost, "kThicknessMost"},
    {kThicknessNeck, "kThicknessNeck"},
    {kThicknessBulge, "kThicknessBulge"},
    {kThicknessStep, "kThicknessStep"},
    {kDistance, "kDistance"},
    {kGeodesic, "kGeodesic"},
    {kDetour, "kDetour"},
    {kConcaveWay, "kConcaveWay"},
    {kConcaveDensity, "kConcaveDensity"},
    {kConcaveBarrier, "kConcaveBarrier"},
    {kCreaseBarrier, "kCreaseBarrier"},
    {kResistance, "kResistance"},
    {kResistanceFar, "kResistanceFar"},
    {kCreaseResistance, "kCreaseResistance"},
    {kCreaseResistanceFar, "kCreaseResistanceFar"},
    {kOutsideMiddle, "kOutsideMiddle"},
    {kOutsideNear, "kOutsideNear"},
    {kOutsideLength, "kOutsideLength"},
    {kSkeletonWay, "kSkeletonWay"},
    {kSkeletonNeck, "kSkeletonNeck"},
    {kSkeletonBulge, "kSkeletonBulge"},
    {kSkeletonJunctions, "kSkeletonJunctions"},
    {kSameBranch, "kSameBranch"},
    {kRadiusLeast, "kRadiusLeast"},
    {kRadiusMost, "kRadiusMost"},
    {kReachLeast, "kReachLeast"},
    {kReachMost, "kReachMost"},
    {kCentralityLeast, "kCentralityLeast"},
    {kCentralityMost, "kCentralityMost"},
    {kNormals, "kNormals"},
}};
static_assert(ossuary::decomposition::in_order(kNames));

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: ossuary_fit_affinity CLASSES.cla MODELS_DIR TRUTH_DIR\n";
        return 2;
    }
    const auto classes = ossuary::ranking::read_classification(argv[1]);
    if (!classes.ok()) {
        std::cerr << classes.error().message << '\n';
        return 1;
    }
    std::vector<Example> examples;
    for (const ossuary::ranking::ClassifiedModel& model :
         ossuary::ranking::models_in_order(*classes)) {
        auto example = example_of(argv[2], argv[3], model.id);
        if (example) examples.push_back(*std::move(example));
    }
    std::cerr << examples.size() << " models\n";
    if (examples.empty()) return 1;
    const auto [mean, deviation] = moments(examples);
    Vector weights = fit(examples, mean, deviation).cwiseQuotient(deviation);
    weights[kUnknowns - 1] -= weights.head<kUnknowns - 1>().dot(mean.head<kUnknowns - 1>());
    for (const auto& [feature, name] : kNames) {
        const auto k = static_cast<Eigen::Index>(feature);
        std::cout << fmt::format("    {{{}, {:.4f}F}},\n", name, weights[k]);
    }
    std::cout << fmt::format("    constant {:.4f}\n", weights[kUnknowns - 1]);
    return 0;
}
