// The blobs of one model: skeleton, global descriptors, signature, preview and thumbnail.

#include <algorithm>
#include <cmath>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/codec.h"

namespace ossuary::index {

namespace {

template <typename T>
bool all_finite(const std::vector<T>& values) {
    return std::all_of(values.begin(), values.end(), [](T value) { return std::isfinite(value); });
}

Vec3 get_point(ByteReader& reader) {
    const auto x = reader.get<double>();
    const auto y = reader.get<double>();
    const auto z = reader.get<double>();
    return {x, y, z};
}

void put_point(ByteWriter& writer, const Vec3& point) {
    writer.put(point.x());
    writer.put(point.y());
    writer.put(point.z());
}

std::size_t count_colours(PreviewColours::Of of, std::size_t vertices, std::size_t triangles) {
    switch (of) {
        case PreviewColours::Of::kNothing:
            return 0;
        case PreviewColours::Of::kModel:
            return 1;
        case PreviewColours::Of::kVertices:
            return vertices;
        case PreviewColours::Of::kTriangles:
            return triangles;
        case PreviewColours::Of::kCorners:
            return 3 * triangles;
    }
    return 0;
}

/// A blob of 32-bit floats behind their number.
std::string encode_floats(const BlobKind& kind, const std::vector<float>& values) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(values.size()));
    writer.put_all<float>(values);
    return seal_blob(kind, writer.bytes());
}

}  // namespace

std::string encode_skeleton(const skeleton::SkeletonGraph& graph) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(graph.nodes.size()));
    for (const skeleton::SkeletonGraph::Node& node : graph.nodes) {
        put_point(writer, node.position);
        writer.put(node.radius);
        writer.put(node.significance);
        writer.put(static_cast<std::int32_t>(node.degree));
    }
    writer.put(static_cast<std::uint32_t>(graph.branches.size()));
    for (const skeleton::SkeletonGraph::Branch& branch : graph.branches) {
        writer.put(branch.a);
        writer.put(branch.b);
        writer.put(static_cast<std::uint32_t>(branch.points.size()));
        for (const Vec3& point : branch.points) put_point(writer, point);
        writer.put_all<double>(branch.radii);
    }
    return seal_blob(kSkeletonBlob, writer.bytes());
}

Result<skeleton::SkeletonGraph> decode_skeleton(std::string_view blob) {
    const auto payload = open_blob(kSkeletonBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    skeleton::SkeletonGraph graph;
    graph.nodes.resize(reader.get_count(44));
    bool finite = true;
    for (skeleton::SkeletonGraph::Node& node : graph.nodes) {
        node.position = get_point(reader);
        node.radius = reader.get<double>();
        node.significance = reader.get<double>();
        node.degree = reader.get<std::int32_t>();
        finite = finite && node.position.allFinite() && std::isfinite(node.radius) &&
                 std::isfinite(node.significance);
    }
    graph.branches.resize(reader.get_count(12 + 2 * 32));
    for (skeleton::SkeletonGraph::Branch& branch : graph.branches) {
        branch.a = reader.get<std::uint32_t>();
        branch.b = reader.get<std::uint32_t>();
        const std::uint32_t count = reader.get_count(32);
        if (!reader.ok()) break;
        if (count < 2) return corrupt_blob(kSkeletonBlob, "a branch of fewer than two points");
        if (std::max(branch.a, branch.b) >= graph.nodes.size()) {
            return corrupt_blob(kSkeletonBlob, "a branch ends at a node that is not there");
        }
        branch.points.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            branch.points.push_back(get_point(reader));
            finite = finite && branch.points.back().allFinite();
        }
        branch.radii = reader.get_all<double>(count);
        finite = finite && all_finite(branch.radii);
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kSkeletonBlob, "wrong length");
    if (!finite) return corrupt_blob(kSkeletonBlob, "a number that is not finite");
    return graph;
}

std::string encode_globals(const std::vector<descriptor::GlobalDescriptor>& globals) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(globals.size()));
    for (const descriptor::GlobalDescriptor& global : globals) {
        writer.put_text(global.name);
        writer.put(static_cast<std::uint32_t>(global.values.size()));
        writer.put_all<std::uint8_t>(global.values);
    }
    return seal_blob(kGlobalsBlob, writer.bytes());
}

Result<std::vector<descriptor::GlobalDescriptor>> decode_globals(std::string_view blob) {
    const auto payload = open_blob(kGlobalsBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    std::vector<descriptor::GlobalDescriptor> globals(reader.get_count(8));
    for (descriptor::GlobalDescriptor& global : globals) {
        global.name = reader.get_text();
        if (blob_version(blob) >= 2) {
            global.values = reader.get_all<std::uint8_t>(reader.get_count(1));
            continue;
        }
        // No ranker of today compares the floats of version 1: only their number is kept.
        const auto floats = reader.get_all<float>(reader.get_count(4));
        if (!all_finite(floats)) return corrupt_blob(kGlobalsBlob, "a number that is not finite");
        global.values.assign(floats.size(), 0);
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kGlobalsBlob, "wrong length");
    return globals;
}

std::string encode_signature(const std::vector<float>& signature) {
    return encode_floats(kSignatureBlob, signature);
}

Result<std::vector<float>> decode_signature(std::string_view blob) {
    const auto payload = open_blob(kSignatureBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    std::vector<float> signature = reader.get_all<float>(reader.get_count(4));
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kSignatureBlob, "wrong length");
    if (!all_finite(signature)) return corrupt_blob(kSignatureBlob, "a number that is not finite");
    return signature;
}

std::string encode_preview(const PreviewMesh& mesh) {
    ByteWriter writer;
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    const bool narrow = vertices <= 0x10000;
    writer.put(vertices);
    writer.put(static_cast<std::uint32_t>(mesh.triangles.size() / 3));
    writer.put(static_cast<std::uint8_t>(narrow ? 2 : 4));
    put_point(writer, mesh.origin);
    writer.put_all<float>(mesh.positions);
    if (narrow) {
        for (const std::uint32_t index : mesh.triangles) {
            writer.put(static_cast<std::uint16_t>(index));
        }
    } else {
        writer.put_all<std::uint32_t>(mesh.triangles);
    }
    writer.put(static_cast<std::uint8_t>(mesh.colours.of));
    writer.put_all<std::uint8_t>(mesh.colours.bytes);
    return seal_blob(kPreviewBlob, writer.bytes());
}

Result<PreviewMesh> decode_preview(std::string_view blob) {
    const auto payload = open_blob(kPreviewBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    const auto vertices = reader.get<std::uint32_t>();
    const auto triangles = reader.get<std::uint32_t>();
    const auto width = reader.get<std::uint8_t>();
    if (width != 2 && width != 4) return corrupt_blob(kPreviewBlob, "index width is not 2 or 4");
    PreviewMesh mesh;
    if (blob_version(blob) >= 2) mesh.origin = get_point(reader);
    mesh.positions = reader.get_all<float>(std::size_t{3} * vertices);
    if (width == 4) {
        mesh.triangles = reader.get_all<std::uint32_t>(std::size_t{3} * triangles);
    } else {
        const auto indices = reader.get_all<std::uint16_t>(std::size_t{3} * triangles);
        mesh.triangles.assign(indices.begin(), indices.end());
    }
    if (blob_version(blob) >= 3) {
        const auto of = reader.get<std::uint8_t>();
        if (of > static_cast<std::uint8_t>(PreviewColours::Of::kCorners)) {
            return corrupt_blob(kPreviewBlob, "colours of what there is not");
        }
        mesh.colours.of = static_cast<PreviewColours::Of>(of);
        mesh.colours.bytes =
            reader.get_all<std::uint8_t>(3 * count_colours(mesh.colours.of, vertices, triangles));
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kPreviewBlob, "wrong length");
    if (!all_finite(mesh.positions) || !mesh.origin.allFinite())
        return corrupt_blob(kPreviewBlob, "a number that is not finite");
    for (const std::uint32_t index : mesh.triangles) {
        if (index >= vertices) return corrupt_blob(kPreviewBlob, "a vertex index out of range");
    }
    return mesh;
}

std::string encode_thumbnail(const std::vector<std::uint8_t>& png) {
    const std::string bytes(png.begin(), png.end());
    return seal_blob(kThumbnailBlob, bytes);
}

Result<std::vector<std::uint8_t>> decode_thumbnail(std::string_view blob) {
    const auto payload = open_blob(kThumbnailBlob, blob);
    if (!payload) return payload.error();
    if (payload->substr(0, 8) != "\x89PNG\r\n\x1a\n") {
        return corrupt_blob(kThumbnailBlob, "not a PNG picture");
    }
    return std::vector<std::uint8_t>(payload->begin(), payload->end());
}

}  // namespace ossuary::index
