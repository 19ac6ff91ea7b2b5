#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/scan_rows.h"
#include "index/model.h"

namespace ossuary::index {

/// Counts every committed change of an index's models, from 0; what readers follow.
using Revision = std::int64_t;

/// Models of a block: those with ids from kScanBlockModels * number on. A block is written anew
/// when one of its models changes, and read whole: some 200 kB.
inline constexpr std::int64_t kScanBlockModels = 128;

/// What searches look at of some models, in flat arrays of the same length, in the order of ids.
struct ScanBlock {
    std::vector<ModelId> ids;
    std::vector<Revision> changed_at;
    std::vector<std::uint64_t> measures;  ///< measures_key: equal for copies of a mesh
    std::vector<std::uint32_t> classes;   ///< into `class_names`
    std::vector<std::string> class_names;
    ranking::ScanRows rows;

    [[nodiscard]] std::size_t size() const { return ids.size(); }
    [[nodiscard]] std::string_view class_name(std::size_t at) const {
        return class_names[classes[at]];
    }
    /// Adds all of a model but its row.
    void append(ModelId id, Revision revision, std::uint64_t measures_of_it,
                std::string_view class_name);
};

/// The same for models whose meshes measure the same to the last bit, wherever their files lie:
/// copies of each other. The bytes of a file say less: the same mesh may be saved under another
/// header.
[[nodiscard]] std::uint64_t measures_key(std::uint32_t vertices, std::uint32_t faces,
                                         double surface_area, const Box3& bounds);

[[nodiscard]] std::string encode_scan_block(const ScanBlock& block);
/// Errors: index_corrupt, also where ids do not ascend.
Result<ScanBlock> decode_scan_block(std::string_view blob);

}  // namespace ossuary::index
