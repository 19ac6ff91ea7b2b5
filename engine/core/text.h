#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Names, paths and messages hold what file systems, clients and other people's files put into them:
// any bytes. What is kept stays as it is; it is made fit where it leaves the program, here.

namespace ossuary {

/// `text` as UTF-8: U+FFFD stands for what is not, once for each maximal subpart of an ill-formed
/// sequence (The Unicode Standard 15.0, sec. 3.9, as the W3C's encoding standard does).
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// The longest beginning of well-formed `text` of at most `max_bytes` that ends between characters.
[[nodiscard]] std::string_view cut_utf8(std::string_view text, std::size_t max_bytes);

/// `text` for a line on a terminal or in a log: line feeds, escapes and other control characters
/// (C0, DEL, C1), what turns the direction of text or separates lines, and bytes that are not UTF-8
/// are written as \n, \x1b, \u202e.
[[nodiscard]] std::string terminal_text(std::string_view text);

/// The same characters inside the strings of a JSON text, as JSON escapes them; C0 already is.
/// For the one writer of JSON, index/json_text.h.
[[nodiscard]] std::string escape_json_controls(std::string json);

}  // namespace ossuary
