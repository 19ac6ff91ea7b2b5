#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/among_others.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/ranker.h"
#include "index/snapshot.h"
#include "index/store_pool.h"

namespace ossuary::index {

/// How well a ranker finds the same body and the same pose, for models that are classified by both.
struct BuildAndPose {
    struct Question {
        ranking::AmongOthers all;     ///< among all models
        ranking::AmongOthers others;  ///< without those that are alike in the other way
    };
    struct Point {
        double weight = 0.0;  ///< RankOptions::pose
        Question build, pose;
    };
    ranking::RankerKind ranker = ranking::RankerKind::kHybrid;
    bool rerank = false;
    std::size_t models = 0, builds = 0, poses = 0;
    std::vector<Point> curve;          ///< by ascending weight
    std::vector<std::string> missing;  ///< named by the classification of builds, not in the index
};

struct BuildAndPoseOptions {
    ranking::Classification build, pose;
    ranking::RankOptions rank;  ///< `pose` is one more weight to measure at
};

/// Measures at the weights 0, .05, .1, .15, .3, .5, .75 and 1 (`chain-code`, which knows no weight,
/// at its own alone) the models that the first classification names; those that the second does not
/// name have no pose. Errors: those of classified_models, cancelled.
Result<BuildAndPose> evaluate_build_and_pose(const Snapshot& snapshot, StorePool& stores,
                                             const BuildAndPoseOptions& options);

[[nodiscard]] nlohmann::json to_json(const BuildAndPose& evaluation);
/// ranker,rerank,weight,question,among,queries,nearest_neighbor,first_tier
[[nodiscard]] std::string build_and_pose_csv(std::span<const BuildAndPose> evaluations);
/// The first tiers of both questions over the weight, for each ranker, as an SVG picture.
[[nodiscard]] std::string build_and_pose_svg(std::span<const BuildAndPose> evaluations);

}  // namespace ossuary::index
