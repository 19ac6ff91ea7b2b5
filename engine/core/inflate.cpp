#include "engine/core/inflate.h"

#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace ossuary {
namespace {

constexpr std::size_t kPiece = 1 << 20;

/// zlib's state, ended whatever happens.
class Inflater {
public:
    Inflater() { ready_ = inflateInit2(&stream_, 16 + MAX_WBITS) == Z_OK; }  // gzip only
    ~Inflater() {
        if (ready_) inflateEnd(&stream_);
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    [[nodiscard]] bool ready() const { return ready_; }
    [[nodiscard]] z_stream& stream() { return stream_; }

private:
    z_stream stream_{};
    bool ready_ = false;
};

using Pieces = std::vector<WholeFile>;

/// What was unpacked, in one piece; each piece is given back as soon as it is copied.
WholeFile joined(Pieces& pieces, std::size_t size) {
    WholeFile whole(size);
    std::size_t at = 0;
    for (WholeFile& piece : pieces) {
        const std::size_t count = std::min(piece.size(), size - at);
        std::memcpy(whole.data() + at, piece.data(), count);
        at += count;
        piece = WholeFile();
    }
    return whole;
}

/// Unpacks into pieces and says how many bytes there are.
Result<std::uint64_t> unpack(std::string_view bytes, const UnpackCaps& caps,
                             const std::stop_token& stop, Pieces& pieces) {
    Inflater inflater;
    if (!inflater.ready()) return {ErrorCode::kOutOfMemory, "not enough memory to unpack"};
    z_stream& stream = inflater.stream();
    std::string_view left = bytes;
    std::uint64_t unpacked = 0;
    const auto invalid = [&](const std::string& what) {
        return Error{ErrorCode::kGzipInvalid,
                     "byte " + std::to_string(bytes.size() - left.size()) + ": " + what};
    };
    std::size_t free_bytes = 0;
    while (true) {
        if (stop.stop_requested()) return {ErrorCode::kCancelled, "unpacking was cancelled"};
        if (free_bytes == 0) {
            pieces.emplace_back(kPiece);
            free_bytes = kPiece;
        }
        constexpr std::size_t kMostAtOnce = std::numeric_limits<uInt>::max();
        stream.next_in = reinterpret_cast<const Bytef*>(left.data());
        stream.avail_in = static_cast<uInt>(std::min(left.size(), kMostAtOnce));
        stream.next_out = reinterpret_cast<Bytef*>(pieces.back().data() + (kPiece - free_bytes));
        stream.avail_out = static_cast<uInt>(free_bytes);
        const std::size_t offered = stream.avail_in;
        const int status = inflate(&stream, Z_NO_FLUSH);
        left.remove_prefix(offered - stream.avail_in);
        unpacked += free_bytes - stream.avail_out;
        free_bytes = stream.avail_out;
        if (!caps.allow(unpacked, bytes.size())) {
            return {ErrorCode::kFileTooLarge,
                    "expected at most " + std::to_string(caps.max_bytes) + " bytes unpacked, and " +
                        std::to_string(caps.max_ratio) + " for one packed, found more"};
        }
        if (status == Z_STREAM_END) {
            if (left.empty()) return unpacked;
            if (!looks_like_gzip(left)) return invalid("expected the end or more gzip data");
            inflateReset(&stream);
            continue;
        }
        if (status == Z_MEM_ERROR) return {ErrorCode::kOutOfMemory, "not enough memory to unpack"};
        const bool stuck = left.empty() && free_bytes > 0;
        if (status == Z_BUF_ERROR || (status == Z_OK && stuck)) {
            if (left.empty()) return invalid("expected more gzip data, found the end of the file");
            continue;
        }
        if (status != Z_OK) {
            return invalid(std::string("expected gzip data, found damaged ones (") +
                           (stream.msg == nullptr ? "no dictionary" : stream.msg) + ")");
        }
    }
}

}  // namespace

bool looks_like_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B\x08"); }

Result<WholeFile> gunzip(std::string_view bytes, std::string_view name, const UnpackCaps& caps,
                         const std::stop_token& stop) {
    Pieces pieces;
    const Result<std::uint64_t> unpacked = unpack(bytes, caps, stop, pieces);
    if (unpacked) return joined(pieces, *unpacked);
    return {unpacked.error().code, std::string(name) + ", " + unpacked.error().message};
}

}  // namespace ossuary
