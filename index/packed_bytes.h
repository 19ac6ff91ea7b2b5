#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ossuary::index {

/// Bytes compressed by Zstandard where that makes them fewer, else as they are; the same bytes
/// always give the same ones.
[[nodiscard]] std::string pack_bytes(std::string_view bytes);

/// What was packed; nothing where these bytes do not come from pack_bytes. Takes memory for at most
/// kMostExpansion times as many bytes.
std::optional<std::string> unpack_bytes(std::string_view packed);

/// No more bytes than this are packed into one.
inline constexpr std::size_t kMostExpansion = 256;

}  // namespace ossuary::index
