// The blob of a model's parts.

#include <algorithm>
#include <cmath>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/codec.h"

namespace ossuary::index {

namespace {

/// As many parts as a label of one byte can tell apart, in version 1.
constexpr std::size_t kNarrowParts = 256;

/// Previews have some thousand triangles; no file makes a reader hold more than so many labels.
constexpr std::uint32_t kMostLabels = std::uint32_t{1} << 20;

/// Stretches of equal labels: the label, and how many there are after the first.
void put_runs(ByteWriter& writer, const std::vector<std::uint32_t>& labels) {
    for (std::size_t begin = 0; begin < labels.size();) {
        std::size_t end = begin + 1;
        while (end < labels.size() && labels[end] == labels[begin]) ++end;
        writer.put_varint(labels[begin]);
        writer.put_varint(end - begin - 1);
        begin = end;
    }
}

std::vector<std::uint32_t> get_runs(ByteReader& reader) {
    const auto count = reader.get<std::uint32_t>();
    if (count > kMostLabels) reader.fail();
    std::vector<std::uint32_t> labels;
    while (reader.ok() && labels.size() < count) {
        const std::uint64_t label = reader.get_varint();
        const std::uint64_t more = reader.get_varint();
        const bool joined = !labels.empty() && labels.back() == label;
        if (!reader.ok() || label > 0xFFFFFFFFU || joined || more >= count - labels.size()) {
            reader.fail();
            break;
        }
        labels.insert(labels.end(), more + 1, static_cast<std::uint32_t>(label));
    }
    return labels;
}

/// What is wrong with a part, if anything.
std::string_view fault_of(const decomposition::Decomposition::Part& part, std::uint32_t number,
                          std::size_t parts) {
    if (!std::isfinite(part.area) || part.area < 0.0) return "a part's area is no area";
    if (part.branch < -1) return "a branch that cannot be";
    const auto& neighbors = part.neighbors;
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
        if (neighbors[i] >= parts || neighbors[i] == number) return "a neighbour that is no part";
        if (i > 0 && neighbors[i] <= neighbors[i - 1]) return "neighbours out of order";
    }
    return {};
}

}  // namespace

std::string encode_segments(const ModelSegments& segments) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(segments.parts.size()));
    for (const decomposition::Decomposition::Part& part : segments.parts) {
        writer.put(part.area);
        writer.put(part.branch);
        writer.put(static_cast<std::uint32_t>(part.neighbors.size()));
        writer.put_all<std::uint32_t>(part.neighbors);
    }
    writer.put(static_cast<std::uint32_t>(segments.labels.size()));
    put_runs(writer, segments.labels);
    return seal_blob(kSegmentsBlob, writer.bytes());
}

Result<ModelSegments> decode_segments(std::string_view blob) {
    const auto payload = open_blob(kSegmentsBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    ModelSegments segments;
    segments.parts.resize(reader.get_count(16));
    for (std::uint32_t p = 0; p < segments.parts.size(); ++p) {
        decomposition::Decomposition::Part& part = segments.parts[p];
        part.area = reader.get<double>();
        part.branch = reader.get<std::int32_t>();
        part.neighbors = reader.get_all<std::uint32_t>(reader.get_count(4));
        if (!reader.ok()) break;
        const std::string_view fault = fault_of(part, p, segments.parts.size());
        if (!fault.empty()) return corrupt_blob(kSegmentsBlob, fault);
    }
    if (blob_version(blob) >= 2) {
        segments.labels = get_runs(reader);
    } else if (segments.parts.size() > kNarrowParts) {
        segments.labels = reader.get_all<std::uint32_t>(reader.get_count(4));
    } else {
        const auto labels = reader.get_all<std::uint8_t>(reader.get_count(1));
        segments.labels.assign(labels.begin(), labels.end());
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kSegmentsBlob, "wrong length");
    for (const std::uint32_t label : segments.labels) {
        if (label >= segments.parts.size())
            return corrupt_blob(kSegmentsBlob, "a label that is no part");
        ++segments.parts[label].triangles;
    }
    for (const decomposition::Decomposition::Part& part : segments.parts) {
        if (part.triangles == 0) return corrupt_blob(kSegmentsBlob, "a part without a triangle");
    }
    return segments;
}

}  // namespace ossuary::index
