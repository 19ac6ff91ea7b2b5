// The blob of a model's skeleton.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "index/blob.h"
#include "index/blob_points.h"
#include "index/bytes.h"
#include "index/codec.h"
#include "index/grid_numbers.h"
#include "index/packed_bytes.h"

namespace ossuary::index {

namespace {

/// Coordinates and radii are floats as they are, not multiples of a power of two.
constexpr std::int16_t kLengthsAsTheyAre = 0x7FFF;

Error wrong_length_of_skeleton() { return corrupt_blob(kSkeletonBlob, "wrong length"); }
Error not_finite_skeleton() { return corrupt_blob(kSkeletonBlob, "a number that is not finite"); }

/// Coordinates and radii, those of nodes first, in the order of the blob.
std::vector<double> lengths_of(const skeleton::SkeletonGraph& graph) {
    std::vector<double> lengths;
    const auto add = [&](const Vec3& point, double radius) {
        lengths.insert(lengths.end(), {point.x(), point.y(), point.z(), radius});
    };
    for (const auto& node : graph.nodes) add(node.position, node.radius);
    for (const auto& branch : graph.branches) {
        for (std::size_t i = 0; i < branch.points.size(); ++i) {
            add(branch.points[i], branch.radii[i]);
        }
    }
    return lengths;
}

/// Four numbers a point, x y z and a radius: of a branch each as how far it is from where a
/// straight line at even steps would lead, beginning at the branch's first node.
class PointCoder {
public:
    using Point = std::array<std::uint64_t, 4>;

    void begin(const Point& start) {
        last_ = start;
        step_ = {};
    }
    void put(const Point& point, ByteWriter& writer) {
        for (std::size_t k = 0; k < 4; ++k) {
            writer.put_signed(static_cast<std::int64_t>(point[k] - last_[k] - step_[k]));
        }
        follow(point);
    }
    Point get(ByteReader& reader) {
        Point point{};
        for (std::size_t k = 0; k < 4; ++k) {
            point[k] = static_cast<std::uint64_t>(reader.get_signed()) + last_[k] + step_[k];
        }
        follow(point);
        return point;
    }

private:
    // Without signs, so that what is no skeleton wraps around.
    void follow(const Point& point) {
        for (std::size_t k = 0; k < 4; ++k) {
            step_[k] = point[k] - last_[k];
            last_[k] = point[k];
        }
    }
    Point last_{}, step_{};
};

PointCoder::Point on_grid(const Vec3& point, double radius, int exponent) {
    const auto multiple = [&](double number) {
        return static_cast<std::uint64_t>(grid_multiple(number, exponent));
    };
    return {multiple(point.x()), multiple(point.y()), multiple(point.z()), multiple(radius)};
}

void from_grid(const PointCoder::Point& point, int exponent, Vec3& position, double& radius) {
    const auto number = [&](std::size_t k) {
        return grid_number(static_cast<std::int64_t>(point[k]), exponent);
    };
    position = {number(0), number(1), number(2)};
    radius = number(3);
}

void put_grid_points(ByteWriter& writer, const skeleton::SkeletonGraph& graph, int exponent) {
    PointCoder coder;
    std::vector<PointCoder::Point> nodes;
    for (const auto& node : graph.nodes) {
        nodes.push_back(on_grid(node.position, node.radius, exponent));
        coder.begin(nodes.size() > 1 ? nodes[nodes.size() - 2] : PointCoder::Point{});
        coder.put(nodes.back(), writer);
    }
    for (const auto& branch : graph.branches) {
        coder.begin(branch.a < nodes.size() ? nodes[branch.a] : PointCoder::Point{});
        for (std::size_t i = 0; i < branch.points.size(); ++i) {
            coder.put(on_grid(branch.points[i], branch.radii[i], exponent), writer);
        }
    }
}

/// @pre the branches' ends are nodes, and they have as many points as are to be read
void get_grid_points(ByteReader& reader, int exponent, skeleton::SkeletonGraph& graph) {
    PointCoder coder;
    std::vector<PointCoder::Point> nodes;
    for (auto& node : graph.nodes) {
        coder.begin(nodes.empty() ? PointCoder::Point{} : nodes.back());
        nodes.push_back(coder.get(reader));
        from_grid(nodes.back(), exponent, node.position, node.radius);
    }
    for (auto& branch : graph.branches) {
        coder.begin(nodes[branch.a]);
        for (std::size_t i = 0; i < branch.points.size(); ++i) {
            from_grid(coder.get(reader), exponent, branch.points[i], branch.radii[i]);
        }
    }
}

void get_plain_points(ByteReader& reader, skeleton::SkeletonGraph& graph) {
    for (auto& node : graph.nodes) {
        node.position = get_point(reader);
        node.radius = reader.get<double>();
    }
    for (auto& branch : graph.branches) {
        for (std::size_t i = 0; i < branch.points.size(); ++i) {
            branch.points[i] = get_point(reader);
            branch.radii[i] = reader.get<double>();
        }
    }
}

bool skeleton_is_finite(const skeleton::SkeletonGraph& graph) {
    for (const auto& node : graph.nodes) {
        if (!std::isfinite(node.significance)) return false;
    }
    const std::vector<double> lengths = lengths_of(graph);
    return std::all_of(lengths.begin(), lengths.end(), [](double x) { return std::isfinite(x); });
}

std::string_view fault_of_branch(const skeleton::SkeletonGraph::Branch& branch, std::size_t nodes,
                                 std::size_t points) {
    if (points < 2) return "a branch of fewer than two points";
    if (std::max(branch.a, branch.b) >= nodes) return "a branch ends at a node that is not there";
    return {};
}

Result<skeleton::SkeletonGraph> decode_plain_skeleton(std::string_view payload) {
    ByteReader reader(payload);
    skeleton::SkeletonGraph graph;
    graph.nodes.resize(reader.get_count(44));
    for (skeleton::SkeletonGraph::Node& node : graph.nodes) {
        node.position = get_point(reader);
        node.radius = reader.get<double>();
        node.significance = reader.get<double>();
        node.degree = reader.get<std::int32_t>();
    }
    graph.branches.resize(reader.get_count(12 + 2 * 32));
    for (skeleton::SkeletonGraph::Branch& branch : graph.branches) {
        branch.a = reader.get<std::uint32_t>();
        branch.b = reader.get<std::uint32_t>();
        const std::uint32_t count = reader.get_count(32);
        if (!reader.ok()) break;
        const std::string_view fault = fault_of_branch(branch, graph.nodes.size(), count);
        if (!fault.empty()) return corrupt_blob(kSkeletonBlob, fault);
        branch.points.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            branch.points.push_back(get_point(reader));
        }
        branch.radii = reader.get_all<double>(count);
    }
    if (!reader.ok() || !reader.at_end()) return wrong_length_of_skeleton();
    return graph;
}

/// Nodes and branches with as many points as they have, all at the origin.
Result<skeleton::SkeletonGraph> get_structure(ByteReader& reader) {
    skeleton::SkeletonGraph graph;
    graph.nodes.resize(reader.get_count(13));
    for (auto& node : graph.nodes) {
        node.significance = reader.get<double>();
        node.degree = static_cast<std::int32_t>(reader.get_varint());
    }
    graph.branches.resize(reader.get_count(11));
    std::size_t points = 0;
    for (auto& branch : graph.branches) {
        branch.a = static_cast<std::uint32_t>(reader.get_varint());
        branch.b = static_cast<std::uint32_t>(reader.get_varint());
        const std::uint64_t count = reader.get_varint();
        // Each point takes four bytes or more.
        if (!reader.ok() || count > reader.left() / 4 - std::min(points, reader.left() / 4)) {
            return wrong_length_of_skeleton();
        }
        const std::string_view fault = fault_of_branch(branch, graph.nodes.size(), count);
        if (!fault.empty()) return corrupt_blob(kSkeletonBlob, fault);
        points += count;
        branch.points.assign(count, Vec3::Zero());
        branch.radii.assign(count, 0.0);
    }
    return graph;
}

Result<skeleton::SkeletonGraph> decode_packed_skeleton(std::string_view payload) {
    const auto unpacked = unpack_bytes(payload);
    if (!unpacked) return corrupt_blob(kSkeletonBlob, "packed bytes that cannot be unpacked");
    ByteReader reader(*unpacked);
    const auto exponent = reader.get<std::int16_t>();
    auto graph = get_structure(reader);
    if (!graph) return graph;
    if (exponent == kLengthsAsTheyAre) {
        get_plain_points(reader, *graph);
    } else if (exponent < kLeastGridExponent || exponent > kMostGridExponent) {
        return corrupt_blob(kSkeletonBlob, "a grid that cannot be");
    } else {
        get_grid_points(reader, exponent, *graph);
    }
    if (!reader.ok() || !reader.at_end()) return wrong_length_of_skeleton();
    return graph;
}

}  // namespace

std::string encode_skeleton(const skeleton::SkeletonGraph& graph) {
    const std::vector<double> lengths = lengths_of(graph);
    const auto exponent = grid_exponent(lengths);
    ByteWriter writer;
    writer.put(exponent ? static_cast<std::int16_t>(*exponent) : kLengthsAsTheyAre);
    writer.put(static_cast<std::uint32_t>(graph.nodes.size()));
    for (const auto& node : graph.nodes) {
        writer.put(node.significance);
        writer.put_varint(static_cast<std::uint32_t>(node.degree));
    }
    writer.put(static_cast<std::uint32_t>(graph.branches.size()));
    for (const auto& branch : graph.branches) {
        writer.put_varint(branch.a);
        writer.put_varint(branch.b);
        writer.put_varint(branch.points.size());
    }
    if (exponent) {
        put_grid_points(writer, graph, *exponent);
    } else {
        writer.put_all<double>(lengths);
    }
    return seal_blob(kSkeletonBlob, pack_bytes(writer.bytes()));
}

Result<skeleton::SkeletonGraph> decode_skeleton(std::string_view blob) {
    const auto payload = open_blob(kSkeletonBlob, blob);
    if (!payload) return payload.error();
    auto graph = blob_version(blob) >= 2 ? decode_packed_skeleton(*payload)
                                         : decode_plain_skeleton(*payload);
    if (graph && !skeleton_is_finite(*graph)) return not_finite_skeleton();
    return graph;
}

}  // namespace ossuary::index
