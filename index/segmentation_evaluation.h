#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/decomposition/decompose.h"
#include "engine/decomposition/segmentation_metrics.h"
#include "engine/ranking/classification.h"

namespace ossuary::index {

struct SegmentationEvaluationOptions {
    std::filesystem::path models;  ///< a folder of N.off
    std::filesystem::path truth;   ///< people's segmentations: N/N_0.seg, N/N_1.seg …
    /// Evaluate these segmentations, N.seg, instead of making some.
    std::filesystem::path segmentations;
    /// The models to evaluate, with their classes; without it all in `models` that have a truth.
    std::optional<ranking::Classification> classification;
    decomposition::DecomposeOptions decompose;
    /// Ask for as many parts as people make of the model in the median.
    bool parts_of_people = false;
    int jobs = 0;
};

/// Means over people for a model, over models for a class or the whole.
struct SegmentationScores : decomposition::SegmentationErrors {
    double cut_discrepancy = 0.0;  ///< over the models where it is defined
    /// The thesis' distance of registered cuts (registered_cuts.h) with people as the reference,
    /// over the square root of the model's area; and of people from each other.
    double registered_cuts = 0.0;
    double additional_cuts = 0.0;  ///< the part of it that cuts without a counterpart make up
    double missing_cuts = 0.0;     ///< people's cuts without one, which it does not count
    double people_registered_cuts = 0.0;
    double people_rand_index_error = 0.0;  ///< of people against each other
    double parts = 0.0;
    double people_parts = 0.0;  ///< in the median
};

struct SegmentationEvaluation {
    struct Model {
        std::string id;
        std::string class_name;                    ///< empty without classification
        decomposition::Segmentation segmentation;  ///< of the file's faces
        SegmentationScores scores;
        bool has_cut_discrepancy = false;
        double took_ms = 0.0;  ///< from mesh to parts, wall clock; 0 where it was read
    };
    struct Row {
        std::string name;
        std::size_t models = 0;
        SegmentationScores scores;
    };
    struct Failure {
        std::string id;
        Error error;
    };
    std::vector<Model> models;
    std::vector<Row> per_class;  ///< in the order of the classification
    Row mean;
    double mean_ms = 0.0;
    std::vector<Failure> failures;
};

/// Segments models and holds the result against what people made of them, by the measures of the
/// Princeton segmentation benchmark (segmentation_metrics.h, cut_discrepancy.h) and by the thesis'
/// distance of registered cuts. A model that
/// cannot be read or segmented is a failure of its own and left out of the means.
/// Errors: file_not_found (a folder), model_not_found (no model with a truth), cancelled.
Result<SegmentationEvaluation> evaluate_segmentation(const SegmentationEvaluationOptions& options,
                                                     std::stop_token stop = {});

[[nodiscard]] nlohmann::json to_json(const SegmentationEvaluation& evaluation);

/// One line a model: id, class and every score.
[[nodiscard]] std::string to_csv(const SegmentationEvaluation& evaluation);

}  // namespace ossuary::index
