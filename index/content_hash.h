#pragma once

#include <string>
#include <string_view>

namespace ossuary::index {

/// XXH3-128 (seed 0) of the bytes as 32 lower-case hexadecimal digits, most significant first: what
/// `xxh128sum` prints. Tells contents apart; no defence against forgery.
[[nodiscard]] std::string content_hash(std::string_view bytes);

/// For one object of a file (ModelPlace) that has a hash.
[[nodiscard]] std::string object_hash(std::string_view file_hash, std::string_view object);

/// True for 32 lower-case hexadecimal digits.
[[nodiscard]] bool is_content_hash(std::string_view text);

}  // namespace ossuary::index
