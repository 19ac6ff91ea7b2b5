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
    bool has_w = false;  ///< each vertex has a fourth coordinate, which divides the others
    bool has_edge_count = true;
    bool names_dimension = false;  ///< before the counts, which must be 3
    /// The word BINARY follows: the scanner is behind its line, and nothing else has been read.
    bool is_binary = false;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::size_t counts_line = 1;  ///< 1-based
};

/// Reads the header word and the counts, and leaves the scanner behind them. Messages do not name
/// the file. Errors: off_header, off_dimension, off_counts.
Result<OffHeader> read_off_header(TextScanner& scanner);

/// Text without what closes the braces around its object: Geomview's programs write OFF files as
/// objects of OOGL, `{ appearance { … } OFF … }`.
[[nodiscard]] std::string_view without_closing_braces(std::string_view text);

/// True for text whose first token, after what OOGL allows before it, looks like the header word of
/// an OFF file, or which starts with a line of three counts; also for what qhull writes.
[[nodiscard]] bool looks_like_off(std::string_view text);

}  // namespace ossuary::mesh
