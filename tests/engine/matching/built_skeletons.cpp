#include "tests/engine/matching/built_skeletons.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ossuary::test {
namespace {

double length_of(const skeleton::SkeletonGraph::Branch& branch) {
    double length = 0.0;
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
        length += (branch.points[i] - branch.points[i - 1]).norm();
    }
    return length;
}

}  // namespace

std::uint32_t SkeletonBuilder::node(const Vec3& position, double radius) {
    graph_.nodes.push_back({position, radius, 0.0, 0});
    return static_cast<std::uint32_t>(graph_.nodes.size() - 1);
}

std::uint32_t SkeletonBuilder::branch(std::uint32_t a, std::uint32_t b, const Vec3& bulge) {
    skeleton::SkeletonGraph::Branch branch;
    branch.a = a;
    branch.b = b;
    const skeleton::SkeletonGraph::Node& from = graph_.nodes[a];
    const skeleton::SkeletonGraph::Node& to = graph_.nodes[b];
    const double reach = (to.position - from.position).norm() + 2.0 * bulge.norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(reach)));
    // A loop through one node runs around an ellipse, so that it encloses something.
    const Vec3 side =
        a == b ? Vec3(bulge.cross(Vec3::UnitZ() + 0.1 * Vec3::UnitX())) : Vec3::Zero();
    for (int k = 0; k <= steps; ++k) {
        const double t = k / static_cast<double>(steps);
        const double height = a == b ? 0.5 - 0.5 * std::cos(2 * M_PI * t) : std::sin(M_PI * t);
        branch.points.emplace_back(
            from.position + t * (to.position - from.position) + height * bulge +
            0.5 * std::sin(2 * M_PI * t) * side.norm() * side.stableNormalized());
        branch.radii.push_back(from.radius + t * (to.radius - from.radius));
    }
    graph_.branches.push_back(std::move(branch));
    return static_cast<std::uint32_t>(graph_.branches.size() - 1);
}

skeleton::SkeletonGraph SkeletonBuilder::graph() const {
    skeleton::SkeletonGraph graph = graph_;
    for (skeleton::SkeletonGraph::Node& node : graph.nodes) node.significance = 10.0 * node.radius;
    for (const skeleton::SkeletonGraph::Branch& branch : graph.branches) {
        for (const std::uint32_t end : {branch.a, branch.b}) {
            ++graph.nodes[end].degree;
            graph.nodes[end].significance += length_of(branch);
        }
    }
    return graph;
}

skeleton::SkeletonGraph human(double pose) {
    SkeletonBuilder b;
    const auto neck = b.node({0, 0, 60}, 7);
    const auto hip = b.node({0, 0, 20}, 9);
    const auto head = b.node({0, 2, 80}, 8);
    const double lift = (pose - 0.5) * 2.2;
    const auto left = b.node({40 * std::cos(lift), 3, 60 + 40 * std::sin(lift)}, 2.5);
    const auto right = b.node({-41 * std::cos(lift), 4, 60 + 41 * std::sin(lift)}, 2.5);
    const auto left_foot = b.node({8 + 20 * pose, 10 * pose, -25}, 3);
    const auto right_foot = b.node({-8 - 16 * pose, -14 * pose, -26}, 3);
    b.branch(neck, hip);
    b.branch(neck, head);
    b.branch(neck, left, {0, 6 * pose, 0});
    b.branch(right, neck, {0, 4 * pose, 2});
    b.branch(hip, left_foot, {0, 8 * pose, 0});
    b.branch(hip, right_foot, {0, 6 * pose, 0});
    return b.graph();
}

skeleton::SkeletonGraph four_leg(double pose) {
    SkeletonBuilder b;
    const auto shoulder = b.node({30, 0, 50}, 12);
    const auto hip = b.node({-30, 0, 48}, 13);
    const auto head = b.node({52, 0, 62 + 14 * pose}, 6);
    const auto tail = b.node({-58, 4 * pose, 40}, 1.5);
    b.branch(shoulder, hip, {0, 0, 3});
    b.branch(shoulder, head);
    b.branch(hip, tail, {0, 0, 6 * pose});
    for (const double side : {-1.0, 1.0}) {
        const auto front = b.node({32 + side * 12 * pose, side * 9, 8}, 3);
        const auto hind = b.node({-32 - side * 14 * pose, side * 9, 7}, 3.5);
        b.branch(shoulder, front, {4 * pose, 0, 0});
        b.branch(hind, hip, {-5 * pose, 0, 0});
    }
    return b.graph();
}

skeleton::SkeletonGraph octopus(double pose) {
    SkeletonBuilder b;
    const auto centre = b.node({0, 0, 0}, 14);
    for (int k = 0; k < 8; ++k) {
        const double angle = M_PI / 4 * k + 0.1 * pose * k;
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        const auto tip = b.node(Vec3(out * (60 + k)), 1.5);
        b.branch(centre, tip, {0, 0, 10 * pose + k});
    }
    return b.graph();
}

skeleton::SkeletonGraph point() {
    SkeletonBuilder b;
    b.node({10, 10, 10}, 20);
    return b.graph();
}

skeleton::SkeletonGraph curve() {
    SkeletonBuilder b;
    b.branch(b.node({0, 0, 0}, 4), b.node({70, 0, 0}, 9), {0, 12, 0});
    return b.graph();
}

skeleton::SkeletonGraph ring() {
    SkeletonBuilder b;
    const auto node = b.node({0, 0, 0}, 5);
    b.branch(node, node, {60, 0, 0});
    return b.graph();
}

skeleton::SkeletonGraph cup() {
    SkeletonBuilder b;
    const auto upper = b.node({0, 0, 40}, 15);
    const auto lower = b.node({0, 0, 10}, 14);
    b.branch(upper, lower);
    b.branch(lower, upper, {30, 0, 0});
    b.branch(upper, b.node({0, 0, 55}, 8));
    b.branch(lower, b.node({0, 0, 0}, 9));
    return b.graph();
}

skeleton::SkeletonGraph figure_eight() {
    SkeletonBuilder b;
    const auto node = b.node({0, 0, 0}, 5);
    b.branch(node, node, {50, 0, 0});
    b.branch(node, node, {-35, 0, 0});
    return b.graph();
}

skeleton::SkeletonGraph two_components() {
    SkeletonBuilder b;
    const auto centre = b.node({0, 0, 0}, 8);
    b.branch(centre, b.node({40, 0, 0}, 3));
    b.branch(centre, b.node({-35, 5, 0}, 3));
    b.branch(centre, b.node({0, 30, 0}, 2));
    b.branch(b.node({0, 0, 50}, 2), b.node({0, 20, 60}, 3), {0, 0, 4});
    b.node({-70, 0, 0}, 6);
    return b.graph();
}

skeleton::SkeletonGraph random_skeleton(std::mt19937& random, int nodes, int extra) {
    std::uniform_real_distribution<double> place(-50, 50), radius(2, 14), bulge(-8, 8);
    const auto any = [&] { return Vec3(place(random), place(random), place(random)); };
    const auto any_bulge = [&] { return Vec3(bulge(random), bulge(random), bulge(random)); };
    SkeletonBuilder b;
    b.node(any(), radius(random));
    for (int i = 1; i < nodes; ++i) {
        const auto to = b.node(any(), radius(random));
        const auto from = std::uniform_int_distribution<std::uint32_t>(0, to - 1)(random);
        b.branch(from, to, any_bulge());
    }
    std::uniform_int_distribution<std::uint32_t> pick(0, static_cast<std::uint32_t>(nodes - 1));
    for (int i = 0; i < extra; ++i) {
        const auto from = pick(random);
        const auto to = pick(random);
        b.branch(from, to, from == to ? Vec3(Vec3(15, 6, 3) + any_bulge()) : any_bulge());
    }
    return b.graph();
}

skeleton::SkeletonGraph renumbered(const skeleton::SkeletonGraph& graph, std::mt19937& random) {
    std::vector<std::uint32_t> place(graph.nodes.size());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), random);
    skeleton::SkeletonGraph result;
    result.nodes.resize(graph.nodes.size());
    for (std::size_t i = 0; i < place.size(); ++i) result.nodes[place[i]] = graph.nodes[i];
    result.branches = graph.branches;
    std::shuffle(result.branches.begin(), result.branches.end(), random);
    for (skeleton::SkeletonGraph::Branch& branch : result.branches) {
        branch.a = place[branch.a];
        branch.b = place[branch.b];
        if (std::bernoulli_distribution()(random)) {
            std::swap(branch.a, branch.b);
            std::reverse(branch.points.begin(), branch.points.end());
            std::reverse(branch.radii.begin(), branch.radii.end());
        }
    }
    return result;
}

skeleton::SkeletonGraph moved(const skeleton::SkeletonGraph& graph, const Mat3& linear,
                              const Vec3& shift, double scale) {
    skeleton::SkeletonGraph result = graph;
    const auto move = [&](Vec3& p) { p = scale * (linear * p) + shift; };
    for (skeleton::SkeletonGraph::Node& node : result.nodes) {
        move(node.position);
        node.radius *= scale;
        node.significance *= scale;
    }
    for (skeleton::SkeletonGraph::Branch& branch : result.branches) {
        for (Vec3& p : branch.points) move(p);
        for (double& radius : branch.radii) radius *= scale;
    }
    return result;
}

std::vector<matching::SkeletonDescriptor> many_skeletons(std::uint32_t seed) {
    std::vector<matching::SkeletonDescriptor> all;
    for (const skeleton::SkeletonGraph& graph :
         {human(0.1), human(0.9), four_leg(0.2), four_leg(0.8), octopus(0.3), curve(), ring(),
          cup(), figure_eight(), two_components(), point(), skeleton::SkeletonGraph{}}) {
        all.push_back(describe(graph));
    }
    std::mt19937 random(seed);
    for (int round = 0; round < 20; ++round) {
        all.push_back(describe(random_skeleton(random, 1 + round, round % 4)));
    }
    return all;
}

matching::SkeletonDescriptor describe(const skeleton::SkeletonGraph& graph, double scale) {
    return matching::describe_skeleton(graph, scale);
}

}  // namespace ossuary::test
