#include "index/packed_bytes.h"

#include <zstd.h>

#include <cstdint>
#include <memory>

#include "index/bytes.h"

namespace ossuary::index {

namespace {

enum class PackedForm : std::uint8_t { kPlain = 0, kZstandard = 1 };

/// Higher levels change little in so few bytes.
constexpr int kZstandardLevel = 12;
constexpr std::size_t kPackedHeader = 5;

/// A context takes 150 kB: made anew for each blob, clearing their pages cost as much as unpacking.
ZSTD_DCtx* unpacking_context() {
    struct Free {
        void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
    };
    thread_local const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
    return context.get();
}

}  // namespace

std::string pack_bytes(std::string_view bytes) {
    std::string packed(kPackedHeader + ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t size =
        ZSTD_compress(packed.data() + kPackedHeader, packed.size() - kPackedHeader, bytes.data(),
                      bytes.size(), kZstandardLevel);
    const bool fewer = ZSTD_isError(size) == 0U && size < bytes.size() &&
                       bytes.size() / kMostExpansion <= size && bytes.size() <= UINT32_MAX;
    ByteWriter header;
    header.put(static_cast<std::uint8_t>(fewer ? PackedForm::kZstandard : PackedForm::kPlain));
    if (!fewer) return header.bytes() + std::string(bytes);
    header.put(static_cast<std::uint32_t>(bytes.size()));
    packed.replace(0, kPackedHeader, header.bytes());
    packed.resize(kPackedHeader + size);
    return packed;
}

std::optional<std::string> unpack_bytes(std::string_view packed) {
    ByteReader reader(packed);
    const auto form = reader.get<std::uint8_t>();
    if (!reader.ok()) return {};
    if (form == static_cast<std::uint8_t>(PackedForm::kPlain)) return std::string(packed.substr(1));
    const auto count = reader.get<std::uint32_t>();
    if (form != static_cast<std::uint8_t>(PackedForm::kZstandard) || !reader.ok()) return {};
    const std::string_view frame = packed.substr(kPackedHeader);
    if (count / kMostExpansion > frame.size()) return {};
    std::string bytes(count, '\0');
    ZSTD_DCtx* context = unpacking_context();
    if (context == nullptr) return {};
    const std::size_t size =
        ZSTD_decompressDCtx(context, bytes.data(), bytes.size(), frame.data(), frame.size());
    if (ZSTD_isError(size) != 0U || size != count) return {};
    return bytes;
}

}  // namespace ossuary::index
