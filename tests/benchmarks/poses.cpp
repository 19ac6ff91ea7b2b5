// Whether `--pose` finds models that stand alike: within a class of the Princeton segmentation
// benchmark the distances of `skeleton` against a reference that knows nothing of skeletons, the
// mean distance between the two surfaces when one is laid over the other as well as it goes, turned
// or mirrored. For each weight the rank correlation of the two over all pairs, how often a model's
// nearest is the reference's nearest or among its three nearest, and the mean share of the class
// that is nearer by the reference than the nearest found (chance: .5).
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/sample_surface.h"
#include "engine/ranking/classification.h"
#include "engine/ranking/ranker.h"
#include "tests/support/benchmark_data.h"

namespace {

using namespace ossuary;
namespace fs = std::filesystem;
using Points = Eigen::Matrix3Xd;

constexpr int kJobs = 2;
constexpr std::size_t kPoints = 200;
constexpr int kRounds = 12;

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

/// Points of the surface, centred, in units of the square root of its area, along principal axes.
Points surface_points(const ossuary::mesh::TriangleMesh& mesh) {
    const auto samples = ossuary::mesh::sample_surface(mesh, {.count = kPoints});
    Points points(3, static_cast<Eigen::Index>(samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        points.col(static_cast<Eigen::Index>(i)) = samples[i].point;
    }
    const Vec3 centre = points.rowwise().mean();
    points.colwise() -= centre;
    points /= std::sqrt(ossuary::mesh::measure(mesh).surface_area);
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(points * points.transpose());
    return axes.eigenvectors().transpose() * points;
}

/// The index of the nearest of `b` to each point of `a`, and the mean distance.
double nearest(const Points& a, const Points& b, std::vector<Eigen::Index>& partner) {
    double sum = 0.0;
    partner.resize(static_cast<std::size_t>(a.cols()));
    for (Eigen::Index i = 0; i < a.cols(); ++i) {
        Eigen::Index best = 0;
        sum += std::sqrt((b.colwise() - a.col(i)).colwise().squaredNorm().minCoeff(&best));
        partner[static_cast<std::size_t>(i)] = best;
    }
    return sum / static_cast<double>(a.cols());
}

/// The orthogonal map that lays `a` best over its partners in `b`, of the same handedness as now.
void turn_onto(Points& a, const Points& b, const std::vector<Eigen::Index>& partner) {
    Mat3 covariance = Mat3::Zero();
    Vec3 shift = Vec3::Zero();
    for (std::size_t i = 0; i < partner.size(); ++i) {
        shift += b.col(partner[i]) - a.col(static_cast<Eigen::Index>(i));
        covariance += b.col(partner[i]) * a.col(static_cast<Eigen::Index>(i)).transpose();
    }
    const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 keep = Mat3::Identity();
    keep(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    a = (svd.matrixU() * keep * svd.matrixV().transpose()) * a;
    a.colwise() += shift / static_cast<double>(partner.size());
}

/// From all 48 ways of laying principal axes over each other, the best after iterating.
double surface_distance(const Points& a, const Points& b) {
    double best = std::numeric_limits<double>::infinity();
    std::array<int, 3> order = {0, 1, 2};
    std::vector<Eigen::Index> there, back;
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Points moved(3, a.cols());
            for (std::size_t axis = 0; axis < 3; ++axis) {
                moved.row(static_cast<int>(axis)) =
                    ((signs >> axis) & 1 ? -1.0 : 1.0) * a.row(order[axis]);
            }
            double distance = 0.0;
            for (int round = 0; round < kRounds; ++round) {
                distance = nearest(moved, b, there);
                // A hopeless start is not worth the rest.
                if (round == 3 && distance > 1.6 * best) break;
                if (round + 1 < kRounds) turn_onto(moved, b, there);
            }
            best = std::min(best, 0.5 * (distance + nearest(b, moved, back)));
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t x, std::size_t y) { return values[x] < values[y]; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
    return rank;
}

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
    const std::vector<double> a = ranks(x), b = ranks(y);
    const double middle = 0.5 * static_cast<double>(x.size() - 1);
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        product += (a[i] - middle) * (b[i] - middle);
        square += (a[i] - middle) * (a[i] - middle);
    }
    return product / square;
}

struct Class {
    std::vector<std::size_t> members;  // rows of the collection
    std::vector<double> reference;     // square matrix
};

void print_weight(const Class& group, const ossuary::ranking::DistanceMatrix& distances,
                  double pose) {
    const std::size_t n = group.members.size();
    std::vector<double> found, wanted;
    double first = 0.0, among_three = 0.0, nearer = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t nearest_found = i;
        const auto at = [&](std::size_t j) {
            return static_cast<double>(distances.at(group.members[i], group.members[j]));
        };
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i) continue;
            if (nearest_found == i || at(j) < at(nearest_found)) nearest_found = j;
            if (j < i) continue;
            found.push_back(at(j));
            wanted.push_back(group.reference[i * n + j]);
        }
        std::size_t before = 0;
        for (std::size_t j = 0; j < n; ++j) {
            if (j != i && group.reference[i * n + j] < group.reference[i * n + nearest_found]) {
                ++before;
            }
        }
        first += before == 0 ? 1.0 : 0.0;
        among_three += before < 3 ? 1.0 : 0.0;
        nearer += static_cast<double>(before) / static_cast<double>(n - 2);
    }
    const auto count = static_cast<double>(n);
    std::cout << fmt::format(
        "pose {:.2f}: rank correlation {:.3f}, reference's nearest {:.2f}, among its three {:.2f}, "
        "nearer by the reference {:.3f}\n",
        pose, rank_correlation(found, wanted), first / count, among_three / count, nearer / count);
}

void run(const fs::path& collection, const std::vector<std::string>& names) {
    const auto models = ossuary::ranking::models_in_order(
        unwrap(ossuary::ranking::read_classification(collection / "segmentation-thesis10.cla")));
    std::vector<ossuary::descriptor::ModelDescriptor> described(models.size());
    std::vector<Points> surfaces(models.size());
    parallel_for(models.size(), kJobs, [&](std::size_t i) {
        const ossuary::mesh::TriangleMesh mesh =
            unwrap(ossuary::mesh::read_mesh(collection / "off" / (models[i].id + ".off"))).mesh;
        described[i] = unwrap(ossuary::descriptor::describe(mesh)).descriptor;
        surfaces[i] = surface_points(mesh);
    });
    std::vector<const ossuary::descriptor::ModelDescriptor*> pointers;
    for (const ossuary::descriptor::ModelDescriptor& model : described) pointers.push_back(&model);
    const ossuary::ranking::CollectionStatistics statistics =
        *ossuary::ranking::collection_statistics(pointers, kJobs);
    std::vector<Class> groups;
    for (const std::string& name : names) {
        Class& group = groups.emplace_back();
        for (std::size_t i = 0; i < models.size(); ++i) {
            if (models[i].class_name == name) group.members.push_back(i);
        }
        const std::size_t n = group.members.size();
        if (n < 3) throw std::runtime_error("no class " + name);
        group.reference.assign(n * n, 0.0);
        parallel_for(n, kJobs, [&](std::size_t i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double distance =
                    surface_distance(surfaces[group.members[i]], surfaces[group.members[j]]);
                group.reference[i * n + j] = distance;
                group.reference[j * n + i] = distance;
            }
        });
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
        std::cout << names[g] << '\n';
        std::vector<const ossuary::descriptor::ModelDescriptor*> members;
        for (const std::size_t i : groups[g].members) members.push_back(&described[i]);
        Class local = groups[g];
        std::iota(local.members.begin(), local.members.end(), std::size_t{0});
        for (const double pose : {0.0, 0.15, 0.5, 1.0}) {
            ossuary::ranking::RankOptions options;
            options.ranker = ossuary::ranking::RankerKind::kSkeleton;
            options.pose = pose;
            options.jobs = kJobs;
            print_weight(local, *ossuary::ranking::distance_matrix(members, statistics, options),
                         pose);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto data = test::benchmark_data();
    if (!data) {
        std::cerr << "usage: ossuary_poses [CLASS…], with OSSUARY_DATA set to the folder of "
                     "princeton-segmentation/\n";
        return 2;
    }
    std::vector<std::string> names(argv + 1, argv + argc);
    if (names.empty()) names = {"armadillo", "human", "hand", "teddy", "fourleg", "octopus"};
    try {
        run(*data / "princeton-segmentation", names);
    } catch (const std::exception& error) {
        std::cerr << "ossuary_poses: " << error.what() << '\n';
        return 1;
    }
}
