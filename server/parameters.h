#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ranking/ranker.h"
#include "engine/voxel/volume_surface.h"
#include "index/searcher.h"
#include "server/request_head.h"

namespace ossuary::server {

/// Reads a request's query parameters strictly: each call names a parameter that is allowed, and
/// `finish` refuses whatever has not been named. The first fault wins and is kept.
class ParameterReader {
public:
    explicit ParameterReader(const RequestHead& head);

    std::optional<std::string> text(std::string_view name, std::size_t max_size = 256,
                                    std::size_t min_size = 1);
    std::optional<std::int64_t> integer(std::string_view name, std::int64_t least,
                                        std::int64_t most);
    std::optional<double> number(std::string_view name, double least, double most);
    std::optional<bool> boolean(std::string_view name);
    /// One of `choices`.
    std::optional<std::string> choice(std::string_view name,
                                      const std::vector<std::string_view>& choices);
    /// Notes that a parameter must be there.
    void require(std::string_view name);
    void refuse(std::string_view name, std::string detail);

    /// The first fault, or one about a parameter that no call has named.
    [[nodiscard]] std::optional<Problem> finish() const;

private:
    const std::string* take(std::string_view name);

    const Fields& fields_;
    std::vector<std::string> known_;
    std::optional<Problem> fault_;
};

/// `ranker`, `pose`, `part` and, where allowed, `rerank`.
ranking::RankOptions read_rank_options(ParameterReader& reader, bool with_rerank);

/// `limit`, `class` and the above.
index::SearchOptions read_search_options(ParameterReader& reader);

/// `threshold` or `label`: what of a volume is the model.
voxel::InsideOptions read_inside(ParameterReader& reader);

/// A positive whole number in a path, as `id`.
Checked<std::int64_t> parse_id(std::string_view text, std::string_view what);

}  // namespace ossuary::server
