// Posed copies of the Princeton segmentation benchmark's bodies, so that both labels are known:
// bodies of a class in the same poses, bent by our own rigs. The limbs of one body of each class
// are looked for on the others, which are laid over it; what does not have all of them about there,
// skins that grow together or limbs held out of sight, takes no part, because what is not bent
// stands as it stood. A pose is a direction in the first body's frame for the upper and for the
// lower half of each limb, so matched limbs stand at the same angles whatever they were at before.
// Skinning is linear and smooth. Writes DEST/off/N.off (N = 100 * body + pose), DEST/build.cla,
// DEST/pose.cla, and the same for every third body alone, which no weight may be chosen by:
// build-kept-out.cla, pose-kept-out.cla; the others are build-tuning.cla, pose-tuning.cla.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "engine/decomposition/rig.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "engine/ranking/classification.h"
#include "tests/benchmarks/limbs.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/random.h"

namespace {

using namespace ossuary;
using benchmarks::Limb;
using benchmarks::LimbMatch;
using benchmarks::LimbPlaces;
using benchmarks::limbs_of;
using benchmarks::match_places;
namespace fs = std::filesystem;

constexpr int kPoses = 8;
constexpr int kKeptOut = 3;  // every third body
constexpr int kDraws = 40;
/// A body takes part when its limbs begin and end this near to those of the first body in the mean,
/// over the root mean square distance of these places from their middle.
constexpr double kFarthest = 0.35;
/// Fewer limbs make no pose, fewer bodies no class.
constexpr std::size_t kLeastLimbs = 4;
constexpr std::size_t kLeastBodies = 4;
constexpr double kMostSwing = 55.0 / 180.0 * std::numbers::pi;
constexpr double kMostBend = 60.0 / 180.0 * std::numbers::pi;

struct Body {
    std::string id;
    mesh::TriangleMesh mesh;
    skeleton::SkeletonGraph skeleton;
    skeleton::SkeletonGraph split;        ///< limbs in two halves
    std::map<std::uint32_t, Limb> limbs;  ///< by the first body's branch
    Mat3 frame = Mat3::Identity();        ///< into the first body's
    decomposition::Rig rig;
};

/// Where a limb's halves point, in the first body's frame.
struct LimbPose {
    Vec3 upper, lower;
};
using PoseOfBody = std::map<std::uint32_t, LimbPose>;

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

Mat3 turn_onto(const Vec3& from, const Vec3& to) {
    return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

Vec3 turned_at_random(const Vec3& direction, double most, std::mt19937_64& random) {
    Vec3 axis;
    do {
        axis = Vec3(test::next_unit(random), test::next_unit(random), test::next_unit(random)) -
               Vec3::Constant(0.5);
    } while (axis.norm() > 0.5 || axis.norm() < 0.05);
    const double angle = most * std::sqrt(test::next_unit(random));
    return Eigen::AngleAxisd(angle, axis.cross(direction).normalized()).toRotationMatrix() *
           direction;
}

/// Spreads weights over about a twenty-fifth of the body, whatever its triangles' size.
int smoothing_of(const mesh::TriangleMesh& mesh) {
    Box3 box;
    for (const Vec3& vertex : mesh.vertices) box.extend(vertex);
    double length = 0.0;
    for (const auto& face : mesh.triangles) {
        length += (mesh.vertices[face[0]] - mesh.vertices[face[1]]).norm();
    }
    const double edge =
        length / static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1));
    const double steps = 0.04 * box.diagonal().norm() / std::max(edge, 1e-12);
    return static_cast<int>(std::clamp(steps * steps, 12.0, 200.0));
}

/// Where the body has the limbs of the first one; none unless it has them all.
std::optional<LimbMatch> match_limbs(const LimbPlaces& first, const LimbPlaces& body) {
    if (body.limbs.size() < first.limbs.size()) return std::nullopt;
    LimbMatch match = match_places(first, body);
    const double places = 2.0 * static_cast<double>(first.limbs.size());
    if (match.cost > kFarthest * places) return std::nullopt;
    return match;
}

/// A class as one of its bodies sees it.
struct Cast {
    std::size_t first = 0;                         ///< whose limbs are looked for
    std::vector<std::optional<LimbMatch>> others;  ///< of each body
    std::size_t count = 0;                         ///< that take part
};

/// The one that most bodies take part in.
Cast best_cast(const std::vector<LimbPlaces>& places) {
    Cast best;
    for (std::size_t first = 0; first < places.size(); ++first) {
        if (places[first].limbs.size() < kLeastLimbs) continue;
        Cast cast{first, {}, 0};
        for (const LimbPlaces& body : places) {
            cast.others.push_back(match_limbs(places[first], body));
            cast.count += cast.others.back() ? 1 : 0;
        }
        if (cast.count > best.count) best = std::move(cast);
    }
    return best;
}

/// Makes the body's limbs bend as the first body's limbs, of these branches, do.
void rig_limbs(const LimbMatch& match, const LimbPlaces& places,
               const std::vector<std::uint32_t>& first_limbs, Body& body) {
    body.frame = match.frame.transpose();
    body.split = body.skeleton;
    for (std::size_t i = 0; i < match.partner.size(); ++i) {
        Limb limb = places.limbs[match.partner[i]];
        benchmarks::split_limb(body.split, limb);
        body.limbs.emplace(first_limbs[i], limb);
    }
    skeleton::update_degrees(body.split);
    body.rig = decomposition::make_rig(body.mesh, body.split, smoothing_of(body.mesh));
}

struct Motion {
    Mat3 rotation = Mat3::Identity();
    Vec3 shift = Vec3::Zero();
    [[nodiscard]] Vec3 operator()(const Vec3& point) const { return rotation * point + shift; }
};

/// How each branch of the split skeleton moves.
std::vector<Motion> motions(const Body& body, const PoseOfBody& pose) {
    std::vector<Motion> result(body.split.branches.size());
    for (const auto& [branch, limb] : body.limbs) {
        const LimbPose& wanted = pose.at(branch);
        const Mat3 upper =
            turn_onto(limb.middle - limb.root, body.frame.transpose() * wanted.upper);
        const Mat3 lower = turn_onto(limb.tip - limb.middle, body.frame.transpose() * wanted.lower);
        result[limb.branch] = {upper, limb.root - upper * limb.root};
        result[limb.second] = {lower, result[limb.branch](limb.middle) - lower * limb.middle};
    }
    return result;
}

/// How deep branches that do not touch each other go into each other, over all pairs of points.
double contact(const Body& body, const PoseOfBody& pose) {
    const std::vector<Motion> moves = motions(body, pose);
    double depth = 0.0;
    const auto& branches = body.split.branches;
    for (std::size_t i = 0; i < branches.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool joined = branches[i].a == branches[j].a || branches[i].a == branches[j].b ||
                                branches[i].b == branches[j].a || branches[i].b == branches[j].b;
            if (joined) continue;
            for (std::size_t k = 0; k < branches[i].points.size(); k += 3) {
                for (std::size_t l = 0; l < branches[j].points.size(); l += 3) {
                    const double gap =
                        (moves[i](branches[i].points[k]) - moves[j](branches[j].points[l])).norm();
                    const double radii = branches[i].radii[k] + branches[j].radii[l];
                    depth += std::max(0.0, 1.2 * radii - gap) / radii;
                }
            }
        }
    }
    return depth;
}

/// Of some poses at random the one in which the bodies touch themselves least.
PoseOfBody draw_pose(const std::vector<Body>& bodies, const std::vector<std::uint32_t>& limbs,
                     std::mt19937_64& random) {
    PoseOfBody best;
    double least = std::numeric_limits<double>::infinity();
    for (int draw = 0; draw < kDraws && least > 0.0; ++draw) {
        PoseOfBody pose;
        for (const std::uint32_t branch : limbs) {
            const Limb& rest = bodies.front().limbs.at(branch);
            const Vec3 upper =
                turned_at_random((rest.middle - rest.root).normalized(), kMostSwing, random);
            pose[branch] = {upper, turned_at_random(upper, kMostBend, random)};
        }
        double depth = 0.0;
        for (const Body& body : bodies) depth += contact(body, pose);
        if (depth < least) least = depth, best = std::move(pose);
    }
    return best;
}

mesh::TriangleMesh posed(const Body& body, const PoseOfBody& pose) {
    const std::vector<Motion> of_branch = motions(body, pose);
    mesh::TriangleMesh result = body.mesh;
    for (std::size_t v = 0; v < result.vertices.size(); ++v) {
        const decomposition::Rig::Weights& weights = body.rig.weights[v];
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < decomposition::Rig::kInfluences; ++k) {
            const auto weight = static_cast<double>(weights.weights[k]);
            if (weight <= 0.0) continue;
            const std::int32_t branch = body.rig.joints[weights.joints[k]].branch;
            const Motion motion =
                branch < 0 ? Motion{} : of_branch[static_cast<std::size_t>(branch)];
            sum += weight * motion(body.mesh.vertices[v]);
        }
        result.vertices[v] = sum;
    }
    return result;
}

/// The class' bodies; of deformed copies of one mesh, which are one body, the first alone.
std::vector<Body> read_bodies(const fs::path& folder, const std::vector<std::string>& ids) {
    std::vector<Body> bodies;
    for (const std::string& id : ids) {
        Body body;
        body.id = id;
        body.mesh = unwrap(mesh::read_mesh(folder / (id + ".off"))).mesh;
        const bool known = std::any_of(bodies.begin(), bodies.end(), [&](const Body& other) {
            return other.mesh.triangles == body.mesh.triangles;
        });
        if (known) continue;
        descriptor::DescribeOptions options;
        options.turned_grids = 0;
        descriptor::Description description = unwrap(descriptor::describe(body.mesh, options));
        body.skeleton = std::move(description.skeleton);
        bodies.push_back(std::move(body));
    }
    return bodies;
}

using Groups = std::vector<std::pair<std::string, std::vector<int>>>;

void write_classes(const fs::path& path, const Groups& groups) {
    std::ofstream out(path);
    std::size_t models = 0;
    for (const auto& group : groups) models += group.second.size();
    out << fmt::format("PSB 1\n{} {}\n\n", groups.size(), models);
    for (const auto& [name, ids] : groups) {
        out << fmt::format("{} 0 {}\n{}\n\n", name, ids.size(), fmt::join(ids, "\n"));
    }
    if (!out) throw std::runtime_error("could not write " + path.string());
}

struct Labels {
    Groups build, pose;
};

/// Poses the bodies of one class; their numbers begin with `next`.
void articulate(const std::string& name, std::vector<Body> all, const fs::path& destination,
                int& next, std::map<std::string, Labels>& labels) {
    std::vector<LimbPlaces> places;
    for (const Body& body : all) places.emplace_back(body.skeleton, limbs_of(body.skeleton));
    const Cast cast = best_cast(places);
    std::cout << fmt::format("{}: {} of {} bodies\n", name, cast.count, all.size());
    if (cast.count < kLeastBodies) return;
    const std::vector<std::uint32_t> limbs = limbs_of(all[cast.first].skeleton);
    std::vector<Body> bodies;
    const auto take = [&](std::size_t index) {
        rig_limbs(*cast.others[index], places[index], limbs, all[index]);
        bodies.push_back(std::move(all[index]));
    };
    take(cast.first);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != cast.first && cast.others[i]) take(i);
    }
    std::cout << fmt::format("  {} limbs\n", limbs.size());
    std::mt19937_64 random(std::accumulate(name.begin(), name.end(), std::uint64_t{1}));
    std::vector<PoseOfBody> poses;
    for (int p = 0; p < kPoses; ++p) poses.push_back(draw_pose(bodies, limbs, random));
    std::map<std::string, std::vector<std::vector<int>>> by_pose;
    for (const Body& body : bodies) {
        const std::string set = next % kKeptOut == kKeptOut - 1 ? "-kept-out" : "-tuning";
        std::vector<int> ids;
        for (int p = 0; p < kPoses; ++p) {
            ids.push_back(100 * next + p);
            const auto written =
                mesh::write_off(posed(body, poses[static_cast<std::size_t>(p)]),
                                destination / "off" / fmt::format("{}.off", ids.back()));
            if (!written) throw std::runtime_error(written.error().message);
            for (const std::string& part : {std::string(), set}) {
                by_pose[part].resize(kPoses);
                by_pose[part][static_cast<std::size_t>(p)].push_back(ids.back());
            }
        }
        for (const std::string& part : {std::string(), set}) {
            labels[part].build.emplace_back(name + body.id, ids);
        }
        ++next;
    }
    for (auto& [part, ids] : by_pose) {
        for (std::size_t p = 0; p < ids.size(); ++p) {
            labels[part].pose.emplace_back(fmt::format("{}-{}", name, p), std::move(ids[p]));
        }
    }
}

void run(const fs::path& data, const fs::path& destination, const std::vector<std::string>& names) {
    fs::create_directories(destination / "off");
    const auto models = ranking::models_in_order(
        unwrap(ranking::read_classification(data / "segmentation-all.cla")));
    std::map<std::string, Labels> labels;
    int next = 0;
    for (const std::string& name : names) {
        std::vector<std::string> ids;
        for (const auto& model : models) {
            if (model.class_name == name) ids.push_back(model.id);
        }
        if (ids.empty()) throw std::runtime_error("no class " + name);
        articulate(name, read_bodies(data / "off", ids), destination, next, labels);
    }
    for (const auto& [part, both] : labels) {
        write_classes(destination / ("build" + part + ".cla"), both.build);
        write_classes(destination / ("pose" + part + ".cla"), both.pose);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    if (!data || argc < 2) {
        std::cerr << "usage: ossuary_articulate DEST [CLASS…], with OSSUARY_DATA set to the folder "
                     "of princeton-segmentation/\n";
        return 2;
    }
    std::vector<std::string> names(argv + 2, argv + argc);
    if (names.empty()) {
        names = {"human", "fourleg", "hand", "octopus", "ant", "teddy", "bird"};
    }
    try {
        run(*data / "princeton-segmentation", argv[1], names);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_articulate: " << error.what() << '\n';
        return 1;
    }
}
