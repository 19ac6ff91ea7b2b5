// Feeds arbitrary payloads to the decoders of an index's blobs. The first byte chooses the kind,
// the second the version; the checksum is made right, since bytes that changed by chance end there.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "index/blob.h"
#include "index/codec.h"
#include "index/scan_block.h"
#include "tests/fuzz/require.h"

namespace {

using namespace ossuary::index;
using ossuary::fuzz::require;

/// What a decoder accepts must come back as it is when it is written and read again.
template <typename Decode, typename Encode>
void check(std::string_view blob, const Decode& decode, const Encode& encode) {
    const auto value = decode(blob);
    if (!value) {
        require(value.error().code == ossuary::ErrorCode::kIndexCorrupt);
        require(!value.error().message.empty());
        return;
    }
    const std::string written = encode(*value);
    const auto again = decode(written);
    require(again.ok());
    require(encode(*again) == written);
}

struct Codec {
    BlobKind kind;
    void (*check)(std::string_view blob);
};

const std::array kCodecs{
    Codec{kSkeletonBlob, [](std::string_view b) { check(b, decode_skeleton, encode_skeleton); }},
    Codec{kDescriptorBlob,
          [](std::string_view b) { check(b, decode_descriptor, encode_descriptor); }},
    Codec{kGlobalsBlob, [](std::string_view b) { check(b, decode_globals, encode_globals); }},
    Codec{kSignatureBlob, [](std::string_view b) { check(b, decode_signature, encode_signature); }},
    Codec{kPreviewBlob, [](std::string_view b) { check(b, decode_preview, encode_preview); }},
    Codec{kSegmentsBlob, [](std::string_view b) { check(b, decode_segments, encode_segments); }},
    Codec{kFeaturesBlob, [](std::string_view b) { check(b, decode_features, encode_features); }},
    Codec{kThumbnailBlob, [](std::string_view b) { check(b, decode_thumbnail, encode_thumbnail); }},
    Codec{kStatisticsBlob,
          [](std::string_view b) { check(b, decode_statistics, encode_statistics); }},
    Codec{kEvaluationBlob, [](std::string_view b) { check(b, decode_report, encode_report); }},
    Codec{kScanBlob, [](std::string_view b) { check(b, decode_scan_block, encode_scan_block); }},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return 0;
    const Codec& codec = kCodecs[data[0] % kCodecs.size()];
    BlobKind kind = codec.kind;
    kind.version = static_cast<std::uint8_t>(1 + data[1] % codec.kind.version);
    const std::string_view payload(reinterpret_cast<const char*>(data) + 2, size - 2);
    codec.check(seal_blob(kind, payload));
    return 0;
}
