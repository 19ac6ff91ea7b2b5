#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {

/// What stands before the first vertex of an OFF file.
struct OffHeader {
    bool has_word = true;  ///< false where the file starts with its counts
    bool has_normals = false;
    bool has_colors = false;
    bool has_texture_coordinates = false;
    bool has_edge_count = true;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::size_t counts_line = 1;  ///< 1-based
};

/// Reads the header word and the counts, and leaves the scanner behind them. Messages do not name
/// the file. Errors: off_header, off_binary, off_dimension, off_counts.
Result<OffHeader> read_off_header(TextScanner& scanner);

/// True for text whose first token looks like the header word of an OFF file, or which starts with
/// a line of three counts.
[[nodiscard]] bool looks_like_off(std::string_view text);

}  // namespace ossuary::mesh
