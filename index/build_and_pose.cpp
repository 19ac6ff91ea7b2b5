#include "index/build_and_pose.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "index/evaluation.h"
#include "index/report_text.h"

namespace ossuary::index {

namespace {

using ranking::AmongOthers;

constexpr std::array kWeights = {0.0, 0.05, 0.1, 0.15, 0.3, 0.5, 0.75, 1.0};

std::vector<double> weights_of(const ranking::RankOptions& rank) {
    if (rank.ranker == ranking::RankerKind::kChainCode) return {rank.pose};
    std::set<double> weights(kWeights.begin(), kWeights.end());
    weights.insert(rank.pose);
    return {weights.begin(), weights.end()};
}

std::size_t different(std::span<const std::string> labels) {
    std::set<std::string> names(labels.begin(), labels.end());
    names.erase("");
    return names.size();
}

BuildAndPose::Question ask(const ranking::DistanceMatrix& distances,
                           std::span<const std::string> labels,
                           std::span<const std::string> others) {
    const std::vector<std::string> none(labels.size());
    return {ranking::among_others(distances, labels, none),
            ranking::among_others(distances, labels, others)};
}

nlohmann::json json_of(const AmongOthers& found) {
    return {{"queries", found.queries},
            {"nearest_neighbor", found.nearest_neighbor},
            {"first_tier", found.first_tier}};
}

nlohmann::json json_of(const BuildAndPose::Question& question, const char* others) {
    nlohmann::json json = json_of(question.all);
    json[others] = json_of(question.others);
    return json;
}

/// A picture of shares over the weight.
class WeightPlot {
public:
    WeightPlot() {
        for (int i = 0; i <= 4; ++i) {
            const double share = 0.25 * i;
            add_line(share, 0.0, share, 1.0);
            add_line(0.0, share, 1.0, share);
            add_text(x_of(share), kHeight - kMargin + 20.0, fixed(share, 2));
            add_text(kMargin - 24.0, y_of(share) + 5.0, fixed(share, 2));
        }
        add_text(0.5 * kWidth, kHeight - 8.0, "weight of pose (--pose)");
    }
    void add_curve(std::span<const std::pair<double, double>> points, std::string_view style,
                   std::string_view name) {
        svg_ += "<polyline fill=\"none\" stroke-width=\"2.5\" " + std::string(style) + " points=\"";
        for (const auto& [x, y] : points) svg_ += fixed(x_of(x), 1) + "," + fixed(y_of(y), 1) + " ";
        svg_ += "\"/>\n";
        const double y = kMargin + 20.0 * static_cast<double>(curves_++);
        svg_ += "<line x1=\"" + fixed(kWidth + 8.0, 1) + "\" y1=\"" + fixed(y, 1) + "\" x2=\"" +
                fixed(kWidth + 48.0, 1) + "\" y2=\"" + fixed(y, 1) + "\" stroke-width=\"2.5\" " +
                std::string(style) + "/>\n<text x=\"" + fixed(kWidth + 56.0, 1) + "\" y=\"" +
                fixed(y + 5.0, 1) + "\">" + markup_text(name) + "</text>\n";
    }
    [[nodiscard]] std::string svg() const {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
               fixed(kWidth + kLegend, 0) + " " + fixed(kHeight, 0) +
               "\" font-family=\"system-ui, sans-serif\" font-size=\"13\" fill=\"#1d232b\">\n" +
               svg_ + "</svg>\n";
    }

private:
    static constexpr double kWidth = 560.0, kHeight = 360.0, kMargin = 48.0, kLegend = 280.0;

    static double x_of(double share) { return kMargin + share * (kWidth - 2.0 * kMargin); }
    static double y_of(double share) {
        return kHeight - kMargin - share * (kHeight - 2.0 * kMargin);
    }
    void add_line(double x1, double y1, double x2, double y2) {
        svg_ += "<line x1=\"" + fixed(x_of(x1), 1) + "\" y1=\"" + fixed(y_of(y1), 1) + "\" x2=\"" +
                fixed(x_of(x2), 1) + "\" y2=\"" + fixed(y_of(y2), 1) + "\" stroke=\"#e3e6ea\"/>\n";
    }
    void add_text(double x, double y, std::string_view text) {
        svg_ += "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) +
                "\" text-anchor=\"middle\">" + markup_text(text) + "</text>\n";
    }

    std::string svg_;
    int curves_ = 0;
};

}  // namespace

Result<BuildAndPose> evaluate_build_and_pose(const Snapshot& snapshot, StorePool& stores,
                                             const BuildAndPoseOptions& options) {
    const auto poses = classified_models(snapshot, stores, options.pose);
    if (!poses) return poses.error();
    std::map<ModelId, std::string> pose_of;
    for (std::size_t i = 0; i < poses->positions.size(); ++i) {
        pose_of.emplace(snapshot.id(poses->positions[i]), poses->labels[i]);
    }
    BuildAndPose result;
    result.ranker = options.rank.ranker;
    result.rerank = options.rank.rerank;
    EvaluateOptions at_weight{options.build, options.rank};
    std::vector<std::string> pose_labels;
    for (const double weight : weights_of(options.rank)) {
        at_weight.rank.pose = weight;
        const auto evaluation = evaluate(snapshot, stores, at_weight);
        if (!evaluation) return evaluation.error();
        if (result.curve.empty()) {
            for (const ModelId id : evaluation->order) {
                const auto found = pose_of.find(id);
                pose_labels.push_back(found != pose_of.end() ? found->second : "");
            }
            result.models = evaluation->order.size();
            result.builds = different(evaluation->labels);
            result.poses = different(pose_labels);
            result.missing = evaluation->missing;
        }
        result.curve.push_back({weight, ask(evaluation->distances, evaluation->labels, pose_labels),
                                ask(evaluation->distances, pose_labels, evaluation->labels)});
    }
    return result;
}

nlohmann::json to_json(const BuildAndPose& evaluation) {
    nlohmann::json curve = nlohmann::json::array();
    for (const BuildAndPose::Point& point : evaluation.curve) {
        curve.push_back({{"weight", point.weight},
                         {"build", json_of(point.build, "among_other_poses")},
                         {"pose", json_of(point.pose, "among_other_builds")}});
    }
    return {{"ranker", to_string(evaluation.ranker)},
            {"rerank", evaluation.rerank},
            {"models", evaluation.models},
            {"builds", evaluation.builds},
            {"poses", evaluation.poses},
            {"missing", evaluation.missing},
            {"curve", std::move(curve)}};
}

std::string build_and_pose_csv(std::span<const BuildAndPose> evaluations) {
    std::string csv = "ranker,rerank,weight,question,among,queries,nearest_neighbor,first_tier\n";
    for (const BuildAndPose& evaluation : evaluations) {
        for (const BuildAndPose::Point& point : evaluation.curve) {
            const auto add = [&](const char* question, const char* among,
                                 const AmongOthers& found) {
                csv += std::string(to_string(evaluation.ranker)) + "," +
                       (evaluation.rerank ? "1" : "0") + "," + fixed(point.weight, 2) + "," +
                       question + "," + among + "," + std::to_string(found.queries) + "," +
                       fixed(found.nearest_neighbor, 6) + "," + fixed(found.first_tier, 6) + "\n";
            };
            add("build", "all", point.build.all);
            add("build", "other_poses", point.build.others);
            add("pose", "all", point.pose.all);
            add("pose", "other_builds", point.pose.others);
        }
    }
    return csv;
}

std::string build_and_pose_svg(std::span<const BuildAndPose> evaluations) {
    // Told apart by people who see few colours, too (Okabe and Ito's set), and by their dashes.
    constexpr std::array<std::string_view, 3> kDashes = {"none", "8 4", "2 4"};
    WeightPlot plot;
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        const auto add = [&](bool build, const char* color, const char* name) {
            std::vector<std::pair<double, double>> points;
            for (const BuildAndPose::Point& point : evaluations[i].curve) {
                points.emplace_back(point.weight, build ? point.build.all.first_tier
                                                        : point.pose.others.first_tier);
            }
            plot.add_curve(points,
                           "stroke=\"" + std::string(color) + "\" stroke-dasharray=\"" +
                               std::string(kDashes[i % kDashes.size()]) + "\"",
                           std::string(to_string(evaluations[i].ranker)) + ": " + name);
        };
        add(true, "#0072b2", "first tier, same build");
        add(false, "#d55e00", "first tier, same pose of others");
    }
    return plot.svg();
}

}  // namespace ossuary::index
