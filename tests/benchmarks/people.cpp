// People of our own making, of whom both labels are known exactly: some builds (lengths, girths and
// the whole size drawn about those of adults), each in the same poses, every joint a few degrees
// off as people are. Bodies are closed surfaces of revolution about their bones, which go through
// each other; y is up, lengths are metres. Writes DEST/off/N.off (N = 100 * build + pose + 1),
// DEST/build.cla and DEST/pose.cla.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/write_mesh.h"
#include "tests/support/random.h"

namespace {

using namespace ossuary;
namespace fs = std::filesystem;

constexpr int kBuilds = 14;
constexpr int kPoses = 14;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMostOff = 4.0 * kDegree;  ///< one standard deviation of a joint

/// Sums of uniform numbers: the same on every machine, which std::normal_distribution is not.
double next_normal(std::mt19937_64& random) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += test::next_unit(random);
    return sum;
}

double next_between(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * test::next_unit(random);
}

Mat3 turn(const Vec3& axis, double angle) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// Lengths and radii, in heights of a body of mean build.
struct Build {
    double size, thigh, shin, upper_arm, forearm, hand, spine, neck, head, shoulder, hip, foot;
    double thigh_radius, knee_radius, ankle_radius, arm_radius, elbow_radius, wrist_radius;
    double hip_radius, waist_radius, chest_radius;

    explicit Build(std::mt19937_64& random) {
        const auto drawn = [&](double mean, double spread) {
            return mean * std::exp(spread * next_normal(random));
        };
        const double girth = drawn(1.0, 0.13);
        size = drawn(1.7, 0.05);
        thigh = drawn(0.245, 0.04), shin = drawn(0.246, 0.04);
        upper_arm = drawn(0.172, 0.04), forearm = drawn(0.157, 0.04), hand = drawn(0.06, 0.05);
        spine = drawn(0.288, 0.035), neck = drawn(0.052, 0.08), head = drawn(0.065, 0.04);
        shoulder = drawn(0.105, 0.06), hip = drawn(0.05, 0.06), foot = drawn(0.09, 0.05);
        thigh_radius = drawn(0.05, 0.06) * girth, knee_radius = drawn(0.032, 0.06) * girth;
        ankle_radius = drawn(0.021, 0.06) * girth, arm_radius = drawn(0.028, 0.06) * girth;
        elbow_radius = drawn(0.022, 0.06) * girth, wrist_radius = drawn(0.016, 0.06) * girth;
        hip_radius = drawn(0.085, 0.06) * girth;
        waist_radius = drawn(0.072, 0.07) * std::pow(girth, 1.5);
        chest_radius = drawn(0.083, 0.06) * girth;
    }
};

struct ArmPose {
    double raised, forward, elbow, plane;
};

struct LegPose {
    double spread, forward, knee;
};

/// Angles in radians; [0] is left.
struct Pose {
    double bend, lean, twist;
    std::array<ArmPose, 2> arms;
    std::array<LegPose, 2> legs;

    explicit Pose(std::mt19937_64& random) {
        const auto between = [&](double low, double high) {
            return kDegree * next_between(random, low, high);
        };
        bend = kDegree * 15.0 * next_normal(random);
        lean = kDegree * 8.0 * next_normal(random);
        twist = kDegree * 12.0 * next_normal(random);
        for (std::size_t side = 0; side < 2; ++side) {
            arms[side] = {between(-20, 170), between(-40, 80), between(0, 120), between(-90, 90)};
            legs[side] = {between(0, 15), between(-15, 40), between(0, 45)};
        }
        if (test::next_unit(random) < 0.4) {
            const std::size_t side = test::next_unit(random) < 0.5 ? 0 : 1;
            legs[side] = {between(0, 30), between(20, 85), between(0, 100)};
        }
    }

    [[nodiscard]] Pose about(std::mt19937_64& random) const {
        Pose pose = *this;
        const auto shake = [&](double& angle) { angle += kMostOff * next_normal(random); };
        shake(pose.bend), shake(pose.lean), shake(pose.twist);
        for (ArmPose& arm : pose.arms) shake(arm.raised), shake(arm.forward), shake(arm.elbow);
        for (LegPose& leg : pose.legs) shake(leg.spread), shake(leg.forward), shake(leg.knee);
        return pose;
    }
};

struct Ring {
    Vec3 middle;
    double radius;
};

/// Adds a tapering bone with round ends. @param flat  the girth across `side` over that along it
void add_bone(mesh::TriangleMesh& mesh, const Ring& from, const Ring& to, double flat = 1.0,
              const Vec3& side = Vec3::UnitX()) {
    constexpr int kAround = 20, kCap = 5, kAlong = 7;
    const Vec3 axis = (to.middle - from.middle).normalized();
    Vec3 u = side - side.dot(axis) * axis;
    if (u.norm() < 1e-3) u = Vec3::UnitZ() - axis.z() * axis;
    u.normalize();
    const Vec3 w = flat * axis.cross(u);
    std::vector<Ring> rings;
    const auto cap = [&](const Ring& end, double first) {
        for (int i = 0; i < kCap; ++i) {
            const double angle = 0.5 * std::numbers::pi * (first + i) / kCap;
            rings.push_back(
                {end.middle + end.radius * std::sin(angle) * axis, end.radius * std::cos(angle)});
        }
    };
    cap(from, -kCap + 1.0);
    for (int i = 1; i < kAlong; ++i) {
        const double t = static_cast<double>(i) / kAlong;
        rings.push_back(
            {(1.0 - t) * from.middle + t * to.middle, (1.0 - t) * from.radius + t * to.radius});
    }
    cap(to, 0.0);
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(from.middle - from.radius * axis);
    for (const Ring& ring : rings) {
        for (int k = 0; k < kAround; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kAround;
            mesh.vertices.push_back(ring.middle +
                                    ring.radius * (std::cos(angle) * u + std::sin(angle) * w));
        }
    }
    mesh.vertices.push_back(to.middle + to.radius * axis);
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto count = static_cast<std::uint32_t>(rings.size());
    for (std::uint32_t k = 0; k < kAround; ++k) {
        const std::uint32_t next = (k + 1) % kAround;
        mesh.triangles.push_back({base, base + 1 + next, base + 1 + k});
        for (std::uint32_t r = 0; r + 1 < count; ++r) {
            const std::uint32_t p = base + 1 + r * kAround + k, q = base + 1 + r * kAround + next;
            mesh.triangles.push_back({p, q, q + kAround});
            mesh.triangles.push_back({p, q + kAround, p + kAround});
        }
        const std::uint32_t ring = base + 1 + (count - 1) * kAround;
        mesh.triangles.push_back({ring + k, ring + next, last});
    }
}

void add_arm(mesh::TriangleMesh& mesh, const Build& build, const ArmPose& pose, double sign,
             const Vec3& chest, const Mat3& trunk) {
    const Vec3 shoulder = chest + trunk * Vec3(sign * build.shoulder, 0.07 * build.spine, 0.0);
    const Vec3 upper = trunk * turn(Vec3::UnitX(), -pose.forward) *
                       turn(Vec3::UnitZ(), sign * pose.raised) * -Vec3::UnitY();
    const Vec3 elbow = shoulder + build.upper_arm * upper;
    const Vec3 hinge = turn(upper, pose.plane) * upper.cross(trunk.col(2)).normalized();
    const Vec3 lower = turn(hinge, -pose.elbow) * upper;
    const Vec3 wrist = elbow + build.forearm * lower;
    add_bone(mesh, {chest + trunk * Vec3(0.03 * sign, 0.0, 0.0), 0.55 * build.chest_radius},
             {shoulder, 1.1 * build.arm_radius}, 0.8, trunk.col(2));
    add_bone(mesh, {shoulder, build.arm_radius}, {elbow, build.elbow_radius});
    add_bone(mesh, {elbow, build.elbow_radius}, {wrist, build.wrist_radius});
    add_bone(mesh, {wrist, 1.2 * build.wrist_radius},
             {wrist + build.hand * lower, 0.9 * build.wrist_radius}, 0.6);
}

void add_leg(mesh::TriangleMesh& mesh, const Build& build, const LegPose& pose, double sign) {
    const Mat3 spread = turn(Vec3::UnitZ(), sign * pose.spread);
    const Mat3 below = turn(Vec3::UnitX(), pose.knee - pose.forward);
    const Vec3 hip(sign * build.hip, 0.0, 0.0);
    const Vec3 knee = hip - build.thigh * (turn(Vec3::UnitX(), -pose.forward) * spread).col(1);
    const Vec3 ankle = knee - build.shin * (below * spread).col(1);
    add_bone(mesh, {hip, build.thigh_radius}, {knee, build.knee_radius});
    add_bone(mesh, {knee, build.knee_radius}, {ankle, build.ankle_radius});
    add_bone(mesh, {ankle, 1.1 * build.ankle_radius},
             {ankle + build.foot * below.col(2), build.ankle_radius}, 0.8);
}

mesh::TriangleMesh figure(const Build& build, const Pose& pose) {
    mesh::TriangleMesh mesh;
    const Mat3 trunk = turn(Vec3::UnitX(), pose.bend) * turn(Vec3::UnitZ(), pose.lean) *
                       turn(Vec3::UnitY(), pose.twist);
    const Vec3 waist = 0.42 * build.spine * turn(Vec3::UnitX(), 0.5 * pose.bend).col(1);
    const Vec3 chest = waist + 0.42 * build.spine * trunk.col(1);
    const Vec3 neck = chest + 0.16 * build.spine * trunk.col(1);
    const Vec3 head = neck + build.neck * trunk.col(1);
    const Vec3 top = head + build.head * trunk.col(1);
    add_bone(mesh, {Vec3::Zero(), build.hip_radius}, {waist, build.waist_radius}, 0.75);
    add_bone(mesh, {waist, build.waist_radius}, {chest, build.chest_radius}, 0.7, trunk.col(0));
    add_bone(mesh, {chest, build.chest_radius}, {neck, 0.5 * build.chest_radius}, 0.7,
             trunk.col(0));
    add_bone(mesh, {neck, 0.03}, {top, 0.035});
    add_bone(mesh, {head + 0.01 * trunk.col(1), 0.05}, {top, 0.052});
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        add_arm(mesh, build, pose.arms[side], sign, chest, trunk);
        add_leg(mesh, build, pose.legs[side], sign);
    }
    for (Vec3& vertex : mesh.vertices) vertex *= build.size;
    return mesh;
}

void write_classes(const fs::path& path, const std::string& name, int classes, int members,
                   int class_step, int member_step) {
    std::ofstream out(path);
    out << fmt::format("PSB 1\n{} {}\n\n", classes, classes * members);
    for (int c = 0; c < classes; ++c) {
        out << fmt::format("{}-{} 0 {}\n", name, c, members);
        for (int m = 0; m < members; ++m) out << 1 + class_step * c + member_step * m << '\n';
        out << '\n';
    }
    if (!out) throw std::runtime_error("could not write " + path.string());
}

void run(const fs::path& destination) {
    fs::create_directories(destination / "off");
    std::mt19937_64 random(1);
    std::vector<Build> builds;
    std::vector<Pose> poses;
    for (int b = 0; b < kBuilds; ++b) builds.emplace_back(random);
    for (int p = 0; p < kPoses; ++p) poses.emplace_back(random);
    for (std::size_t b = 0; b < builds.size(); ++b) {
        for (std::size_t p = 0; p < poses.size(); ++p) {
            const fs::path path = destination / "off" / fmt::format("{}.off", 100 * b + p + 1);
            const auto written = mesh::write_off(figure(builds[b], poses[p].about(random)), path);
            if (!written) throw std::runtime_error(written.error().message);
        }
    }
    write_classes(destination / "build.cla", "build", kBuilds, kPoses, 100, 1);
    write_classes(destination / "pose.cla", "pose", kPoses, kBuilds, 1, 100);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: ossuary_people DEST\n";
        return 2;
    }
    try {
        run(argv[1]);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_people: " << error.what() << '\n';
        return 1;
    }
}
