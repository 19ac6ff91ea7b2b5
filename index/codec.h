#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/ranking/ranker.h"
#include "engine/ranking/retrieval_metrics.h"
#include "engine/registration/piece_search.h"
#include "engine/skeleton/skeleton_graph.h"
#include "index/model.h"

namespace ossuary::index {

// The blobs of an index, byte for byte as docs/index-format.md says. Encoding and decoding give
// back the same value, floats bit by bit. A decoder reads only what is there, allocates no more
// than a small multiple of it, and refuses with index_corrupt whatever would break a precondition
// further on: indices out of range, numbers that are not finite, bytes left over.

[[nodiscard]] std::string encode_skeleton(const skeleton::SkeletonGraph& graph);
Result<skeleton::SkeletonGraph> decode_skeleton(std::string_view blob);

/// Nodes and branches only; what is derived from them is not stored.
[[nodiscard]] std::string encode_descriptor(const matching::SkeletonDescriptor& descriptor);
/// Without derived data: call derive_matching_data before matching.
Result<matching::SkeletonDescriptor> decode_descriptor(std::string_view blob);

[[nodiscard]] std::string encode_globals(const std::vector<descriptor::GlobalDescriptor>& globals);
Result<std::vector<descriptor::GlobalDescriptor>> decode_globals(std::string_view blob);

[[nodiscard]] std::string encode_signature(const std::vector<float>& signature);
Result<std::vector<float>> decode_signature(std::string_view blob);

[[nodiscard]] std::string encode_preview(const PreviewMesh& mesh);
Result<PreviewMesh> decode_preview(std::string_view blob);

[[nodiscard]] std::string encode_segments(const ModelSegments& segments);
Result<ModelSegments> decode_segments(std::string_view blob);

/// Normals are rounded to 1/127, points to 32-bit floats about the first of them.
/// @pre values of features are coarse (local_features.h)
[[nodiscard]] std::string encode_features(const registration::WholeFeatures& whole);
Result<registration::WholeFeatures> decode_features(std::string_view blob);

[[nodiscard]] std::string encode_thumbnail(const std::vector<std::uint8_t>& png);
Result<std::vector<std::uint8_t>> decode_thumbnail(std::string_view blob);

[[nodiscard]] std::string encode_statistics(const ranking::CollectionStatistics& statistics);
Result<ranking::CollectionStatistics> decode_statistics(std::string_view blob);

[[nodiscard]] std::string encode_report(const ranking::RetrievalReport& report);
Result<ranking::RetrievalReport> decode_report(std::string_view blob);

/// Warnings as JSON text: [{"code": …, "count": …, "message": …}].
[[nodiscard]] std::string encode_warnings(const std::vector<mesh::MeshWarning>& warnings);
Result<std::vector<mesh::MeshWarning>> decode_warnings(std::string_view text);

}  // namespace ossuary::index
