#pragma once

#include <cstdint>
#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/core/whole_file.h"

namespace ossuary {

/// What packed data may become: small files that unpack to more than any machine holds are made to
/// do harm.
struct UnpackCaps {
    std::uint64_t max_bytes = std::uint64_t{512} << 20;
    /// Bytes for one packed byte, once there are more than `ratio_from` of them.
    std::uint64_t max_ratio = 300;
    std::uint64_t ratio_from = std::uint64_t{64} << 20;

    [[nodiscard]] bool allow(std::uint64_t unpacked, std::uint64_t packed) const {
        return unpacked <= max_bytes && (unpacked <= ratio_from || unpacked / max_ratio <= packed);
    }
};

/// Whether bytes begin as gzip data do.
[[nodiscard]] bool looks_like_gzip(std::string_view bytes);

/// Unpacks gzip data (RFC 1952), all members one after the other; checksums are checked. `name`
/// stands for the file in messages.
/// Errors: gzip_invalid (damaged, cut off, something else after the last member),
/// file_too_large (beyond the caps; found while unpacking, whatever the data announce),
/// out_of_memory, cancelled.
Result<WholeFile> gunzip(std::string_view bytes, std::string_view name, const UnpackCaps& caps = {},
                         const std::stop_token& stop = {});

}  // namespace ossuary
