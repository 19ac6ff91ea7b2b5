#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "engine/chain_code/five_element_code.h"
#include "engine/chain_code/orthogonalize.h"
#include "engine/matching/resample.h"
#include "engine/matching/skeleton_descriptor.h"

namespace ossuary::matching {
namespace {

std::string code_of(std::span<const Vec3> points, bool reversed) {
    std::vector<Vec3> walked(points.begin(), points.end());
    if (reversed) std::reverse(walked.begin(), walked.end());
    return chain_code::five_element_code(chain_code::orthogonalize(walked));
}

/// Coded from the more significant node; between equals the code that reads higher is taken, so
/// that the way in which the branch is stored does not matter.
std::string branch_chain_code(const skeleton::SkeletonGraph& graph,
                              const skeleton::SkeletonGraph::Branch& branch) {
    const skeleton::SkeletonGraph::Node& a = graph.nodes[branch.a];
    const skeleton::SkeletonGraph::Node& b = graph.nodes[branch.b];
    const auto first = std::tie(a.significance, a.radius);
    const auto second = std::tie(b.significance, b.radius);
    if (first > second) return code_of(branch.points, false);
    if (second > first) return code_of(branch.points, true);
    return std::max(code_of(branch.points, false), code_of(branch.points, true));
}

/// Mean of the skeleton's points along its branches; of its nodes where it has no length.
Vec3 centre_of(const std::vector<ResampledCurve>& curves, const skeleton::SkeletonGraph& graph) {
    Vec3 sum = Vec3::Zero();
    double length = 0.0;
    for (const ResampledCurve& curve : curves) {
        const double step = curve.length / static_cast<double>(curve.points.size() - 1);
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
            sum += 0.5 * step * (curve.points[i - 1] + curve.points[i]).cast<double>();
        }
        length += curve.length;
    }
    if (length > 0.0) return sum / length;
    for (const skeleton::SkeletonGraph::Node& node : graph.nodes) sum += node.position;
    return graph.nodes.empty() ? sum : Vec3(sum / static_cast<double>(graph.nodes.size()));
}

/// The nearest whole multiple of a unit; 0 has no sign.
float rounded(double value, float unit) {
    return static_cast<float>(std::round(value / static_cast<double>(unit))) * unit + 0.0F;
}

/// FNV-1a.
class ContentHash {
public:
    template <typename T>
    void add(std::span<const T> values) {
        for (const std::byte byte : std::as_bytes(values)) {
            hash_ = (hash_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3ULL;
        }
    }
    template <typename T>
    void add(const T& value) {
        add(std::span<const T>(&value, 1));
    }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

std::uint64_t content_key(const SkeletonDescriptor& descriptor) {
    ContentHash hash;
    for (const SkeletonDescriptor::Node& node : descriptor.nodes) {
        hash.add(std::span<const float>(node.position));
        hash.add(node.radius);
        hash.add(node.significance);
    }
    for (const SkeletonDescriptor::Branch& branch : descriptor.branches) {
        hash.add(branch.a);
        hash.add(branch.b);
        hash.add(std::span<const char>(branch.chain_code));
        hash.add(std::span<const float>(branch.points));
        hash.add(std::span<const float>(branch.radii));
        hash.add(branch.length);
    }
    return hash.value();
}

/// A sum, in which no node comes before another. Radii are the same to the last bit wherever a
/// skeleton lies and however it is numbered; lengths and significances are sums themselves.
std::uint64_t shape_key(const SkeletonDescriptor& descriptor) {
    std::uint64_t sum = 0;
    for (const SkeletonDescriptor::Node& node : descriptor.nodes) {
        ContentHash hash;
        hash.add(node.radius);
        sum += hash.value();
    }
    return sum;
}

}  // namespace

SkeletonDescriptor trace_skeleton(const skeleton::SkeletonGraph& refined, double scale,
                                  const DescribeSkeletonOptions& options) {
    assert(scale > 0.0);
    SkeletonDescriptor descriptor;
    std::vector<ResampledCurve> curves;
    for (const skeleton::SkeletonGraph::Branch& branch : refined.branches) {
        curves.push_back(resample(branch.points, branch.radii, options.sample_step * scale,
                                  options.max_samples));
    }
    const Vec3 centre = centre_of(curves, refined);
    double significance = 0.0;
    for (const skeleton::SkeletonGraph::Node& node : refined.nodes)
        significance += node.significance;
    for (const skeleton::SkeletonGraph::Node& node : refined.nodes) {
        SkeletonDescriptor::Node& described = descriptor.nodes.emplace_back();
        const Vec3f position = ((node.position - centre) / scale).cast<float>();
        described.position = {position.x(), position.y(), position.z()};
        described.radius = static_cast<float>(node.radius / scale);
        if (significance > 0.0) {
            described.significance = static_cast<float>(node.significance / significance);
        }
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        SkeletonDescriptor::Branch& branch = descriptor.branches.emplace_back();
        branch.a = refined.branches[i].a;
        branch.b = refined.branches[i].b;
        branch.length = static_cast<float>(curves[i].length / scale);
        for (const Vec3f& point : curves[i].points) {
            const Vec3 p = (point.cast<double>() - centre) / scale;
            for (const double coordinate : p) {
                branch.points.push_back(rounded(coordinate, kPointUnit));
            }
        }
        for (const float radius : curves[i].radii) {
            branch.radii.push_back(rounded(radius / scale, kRadiusUnit));
        }
    }
    return descriptor;
}

SkeletonDescriptor describe_skeleton(const skeleton::SkeletonGraph& refined, double scale,
                                     const DescribeSkeletonOptions& options) {
    SkeletonDescriptor descriptor = trace_skeleton(refined, scale, options);
    for (std::size_t i = 0; i < refined.branches.size(); ++i) {
        descriptor.branches[i].chain_code = branch_chain_code(refined, refined.branches[i]);
    }
    derive_matching_data(descriptor);
    return descriptor;
}

void derive_matching_data(SkeletonDescriptor& descriptor, const RootingOptions& options) {
    descriptor.rooted = root_skeleton(descriptor, options);
    descriptor.rooted.content_key = content_key(descriptor);
    descriptor.rooted.shape_key = shape_key(descriptor);
    descriptor.hierarchy = signature_tree(descriptor);
}

}  // namespace ossuary::matching
