// A large index of different models from a small one, much faster than describing them: DESCRIPTORS
// ARE PERTURBED, not measured. The models of FROM, which were really described, are copied as they
// are; every other model of OUT descends from one of them: its skeleton is stretched, bent, twisted
// and made thicker or thinner, it may lose a limb, and what can be computed from a skeleton is
// computed anew (pairs, layout, the signature, all that matching needs). Global descriptors that
// only a solid has go from the original towards those of three other models, which are the same for
// all descendants of one, as far as the same few numbers say that shape the skeleton: histograms of
// a union of two bodies are about the mean of theirs. So models that are near in these numbers are
// near in all components, and no two are equal. The same for the same seed.
//   ossuary_grow FROM OUT COUNT [SEED [pictures]]
// Without `pictures` descendants have a preview of one triangle, no parts and no thumbnail.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/descriptor/global_descriptors.h"
#include "engine/descriptor/signature.h"
#include "index/content_hash.h"
#include "index/store.h"
#include "tests/support/random.h"

namespace {

using namespace ossuary;
using test::next_unit;

constexpr std::size_t kModelsPerTransaction = 256;
constexpr std::size_t kPartners = 3;
constexpr double kMostOfPartner = 0.35;
constexpr std::size_t kNumbers = 9;  ///< three stretches, bend, twist, thickness, the partners

template <typename T>
T unwrap(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return *std::move(result);
}

struct Family {
    index::NewModel model;
    std::array<std::size_t, kPartners> partners{};
    Mat3 frame = Mat3::Identity();
};

/// Each in [-1, 1]: what makes one descendant another than its brothers.
using Numbers = std::array<double, kNumbers>;

std::vector<Family> read_families(const std::filesystem::path& from, bool pictures) {
    auto store = unwrap(index::Store::open(from, index::Access::kReadOnly));
    index::ModelFilter everything;
    everything.limit = 0;
    const auto page = unwrap(store.models(everything));
    std::vector<Family> families;
    for (const index::ModelSummary& summary : page.models) {
        const index::ModelId ids[] = {summary.id};
        Family family;
        family.model.summary = summary;
        family.model.descriptor = unwrap(store.descriptors(ids)).front().descriptor;
        family.model.skeleton = unwrap(store.skeleton(summary.id)).graph;
        if (pictures) {
            family.model.preview = unwrap(store.preview(summary.id));
            family.model.segments = unwrap(store.segments(summary.id));
            if (auto png = store.thumbnail(summary.id)) family.model.thumbnail = *std::move(png);
        } else {
            family.model.preview.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
            family.model.preview.triangles = {0, 1, 2};
        }
        if (!family.model.segments) {
            family.model.summary.warnings.push_back({std::string(index::kSegmentsMissing), 1, ""});
        }
        std::mt19937_64 random(static_cast<std::uint64_t>(summary.id));
        family.frame = Eigen::Quaterniond(next_unit(random) - 0.5, next_unit(random) - 0.5,
                                          next_unit(random) - 0.5, next_unit(random) - 0.5)
                           .normalized()
                           .toRotationMatrix();
        for (std::size_t& partner : family.partners) {
            partner = test::next_below(random, page.models.size());
        }
        families.push_back(std::move(family));
    }
    return families;
}

Vec3 moved(const Vec3& point, const Mat3& frame, const Numbers& numbers) {
    Vec3 at = frame * point;
    for (int axis = 0; axis < 3; ++axis) {
        at[axis] *= std::exp(0.3 * numbers[static_cast<std::size_t>(axis)]);
    }
    at = Eigen::AngleAxisd(0.5 * numbers[4] * at.z(), Vec3::UnitZ()) * at;
    const double bend = 0.7 * numbers[3];
    if (std::abs(bend) > 1e-3) {
        const double radius = 1.0 / bend;
        const double from_centre = radius - at.x();
        at = Vec3(radius - from_centre * std::cos(bend * at.z()), at.y(),
                  from_centre * std::sin(bend * at.z()));
    }
    return frame.transpose() * at;
}

void move_skeleton(matching::SkeletonDescriptor& skeleton, const Mat3& frame,
                   const Numbers& numbers) {
    const auto thicker = static_cast<float>(std::exp(0.3 * numbers[5]));
    const auto at = [&](float* xyz) {
        const Vec3 point = moved(Vec3(xyz[0], xyz[1], xyz[2]), frame, numbers);
        for (int axis = 0; axis < 3; ++axis) xyz[axis] = static_cast<float>(point[axis]);
    };
    const auto rounded = [](float value, float unit) {
        return static_cast<float>(std::lround(value / unit)) * unit;
    };
    for (auto& node : skeleton.nodes) {
        at(node.position.data());
        node.radius *= thicker;
    }
    for (auto& branch : skeleton.branches) {
        double before = 0.0, after = 0.0;
        const auto length = [&] {
            double sum = 0.0;
            for (std::size_t i = 3; i < branch.points.size(); i += 3) {
                const float* p = branch.points.data() + i;
                sum += std::hypot(p[0] - p[-3], p[1] - p[-2], p[2] - p[-1]);
            }
            return sum;
        };
        before = length();
        for (std::size_t i = 0; i < branch.points.size(); i += 3) at(branch.points.data() + i);
        for (float& value : branch.points) value = rounded(value, matching::kPointUnit);
        after = length();
        if (before > 0.0) branch.length *= static_cast<float>(after / before);
        for (float& radius : branch.radii) {
            radius = std::min(rounded(radius * thicker, matching::kRadiusUnit), 0.999F);
        }
    }
}

/// Takes away branch `at` of a skeleton and the end point that it led to.
template <typename Skeleton>
void drop(Skeleton& skeleton, std::size_t at, std::uint32_t tip) {
    skeleton.branches.erase(skeleton.branches.begin() + static_cast<std::ptrdiff_t>(at));
    skeleton.nodes.erase(skeleton.nodes.begin() + tip);
    for (auto& branch : skeleton.branches) {
        for (std::uint32_t* end : {&branch.a, &branch.b}) {
            if (*end > tip) --*end;
        }
    }
}

void drop_a_limb(index::NewModel& model, std::mt19937_64& random) {
    auto& skeleton = model.descriptor.skeleton;
    if (skeleton.branches.size() < 4) return;
    std::vector<int> degree(skeleton.nodes.size(), 0);
    for (const auto& branch : skeleton.branches) {
        ++degree[branch.a];
        ++degree[branch.b];
    }
    const std::size_t at = test::next_below(random, skeleton.branches.size());
    const auto& branch = skeleton.branches[at];
    if (branch.a == branch.b || (degree[branch.a] != 1 && degree[branch.b] != 1)) return;
    const std::uint32_t tip = degree[branch.a] == 1 ? branch.a : branch.b;
    drop(skeleton, at, tip);
    drop(model.skeleton, at, tip);
    skeleton::update_degrees(model.skeleton);
}

void mix(std::vector<std::uint8_t>& values, const std::vector<std::uint8_t>& other, double share) {
    for (std::size_t i = 0; i < std::min(values.size(), other.size()); ++i) {
        const double a = values[i], b = other[i];
        values[i] = static_cast<std::uint8_t>(
            std::lround(std::sqrt((1.0 - share) * a * a + share * b * b)));
    }
}

void change_globals(descriptor::ModelDescriptor& model, const std::vector<Family>& families,
                    const Family& family, const Numbers& numbers) {
    const matching::SkeletonDescriptor skeletons[] = {model.skeleton};
    for (std::size_t place = 0; place < model.globals.size(); ++place) {
        std::vector<std::uint8_t>& values = model.globals[place].values;
        if (place == descriptor::kSkeletonPairsPlace) {
            values = descriptor::skeleton_pairs(skeletons);
        } else if (place == descriptor::kSkeletonLayoutPlace) {
            values = descriptor::skeleton_layout(skeletons);
        } else if (place != descriptor::kPosePointsPlace && place != descriptor::kBodySizePlace) {
            for (std::size_t k = 0; k < kPartners; ++k) {
                const double share = 0.5 * kMostOfPartner * (1.0 + numbers[6 + k]);
                const auto& other = families[family.partners[k]].model.descriptor.globals;
                mix(values, other[place].values, share);
            }
        }
    }
}

index::NewModel descendant(const std::vector<Family>& families, std::size_t number,
                           std::uint64_t seed) {
    std::mt19937_64 random(seed * 0x9E3779B97F4A7C15ULL + number);
    const std::size_t own = number % families.size();
    const Family& family = families[own];
    Numbers numbers{};
    for (double& value : numbers) value = 2.0 * next_unit(random) - 1.0;
    index::NewModel model = family.model;
    if (next_unit(random) < 0.3) drop_a_limb(model, random);
    move_skeleton(model.descriptor.skeleton, family.frame, numbers);
    matching::derive_matching_data(model.descriptor.skeleton);
    change_globals(model.descriptor, families, family, numbers);
    model.descriptor.signature =
        descriptor::preselection_signature(model.descriptor.skeleton, model.descriptor.globals);
    if (model.segments) {
        for (auto& part : model.segments->parts) part.branch = -1;
    }
    index::ModelSummary& summary = model.summary;
    summary.id = 0;
    summary.name = fmt::format("{}-{:07}", family.model.summary.name, number);
    summary.path = fmt::format("/grown/{:03}/{}.off", number / 2000, summary.name);
    summary.content_hash = index::content_hash(fmt::format("grown {} {}", seed, number));
    summary.surface_area *= std::exp(numbers[0] + numbers[1]);
    if (summary.class_name.empty()) summary.class_name = fmt::format("family-{:04}", own);
    return model;
}

void grow(const std::filesystem::path& from, const std::filesystem::path& out, std::size_t count,
          std::uint64_t seed, bool pictures) {
    const std::vector<Family> families = read_families(from, pictures);
    auto source = unwrap(index::Store::open(from, index::Access::kReadOnly));
    auto store = unwrap(index::Store::create_or_open(out, source.parameters()));
    for (std::size_t first = 0; first < count; first += kModelsPerTransaction) {
        const std::size_t size = std::min(kModelsPerTransaction, count - first);
        std::vector<index::Change> changes(size);
        parallel_for(size, 0, [&](std::size_t i) {
            const std::size_t number = first + i;
            changes[i] =
                index::PutModel{number < families.size() ? families[number].model
                                                         : descendant(families, number, seed)};
        });
        unwrap(store.apply(changes));
        if (first / kModelsPerTransaction % 40 == 0) {
            std::cerr << first + size << " of " << count << '\n';
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: ossuary_grow FROM OUT COUNT [SEED [pictures]]\n";
        return 2;
    }
    try {
        grow(argv[1], argv[2], std::strtoull(argv[3], nullptr, 10),
             argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1,
             argc > 5 && std::string(argv[5]) == "pictures");
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
