// The blobs of one model: global descriptors, signature and thumbnail.

#include <algorithm>
#include <cmath>
#include <optional>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/codec.h"
#include "index/packed_bytes.h"

namespace ossuary::index {

namespace {

template <typename T>
bool all_finite(const std::vector<T>& values) {
    return std::all_of(values.begin(), values.end(), [](T value) { return std::isfinite(value); });
}

/// A blob of 32-bit floats behind their number.
std::string encode_floats(const BlobKind& kind, const std::vector<float>& values) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(values.size()));
    writer.put_all<float>(values);
    return seal_blob(kind, writer.bytes());
}

}  // namespace

std::string encode_globals(const std::vector<descriptor::GlobalDescriptor>& globals) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(globals.size()));
    for (const descriptor::GlobalDescriptor& global : globals) {
        writer.put_text(global.name);
        writer.put(static_cast<std::uint32_t>(global.values.size()));
        writer.put_all<std::uint8_t>(global.values);
    }
    return seal_blob(kGlobalsBlob, pack_bytes(writer.bytes()));
}

Result<std::vector<descriptor::GlobalDescriptor>> decode_globals(std::string_view blob) {
    const auto payload = open_blob(kGlobalsBlob, blob);
    if (!payload) return payload.error();
    std::optional<std::string> unpacked;
    if (blob_version(blob) >= 3) {
        unpacked = unpack_bytes(*payload);
        if (!unpacked) return corrupt_blob(kGlobalsBlob, "packed bytes that cannot be unpacked");
    }
    ByteReader reader(unpacked ? std::string_view(*unpacked) : *payload);
    std::vector<descriptor::GlobalDescriptor> globals(reader.get_count(8));
    for (descriptor::GlobalDescriptor& global : globals) {
        global.name = reader.get_text();
        if (blob_version(blob) >= 2) {
            global.values = reader.get_all<std::uint8_t>(reader.get_count(1));
            continue;
        }
        // No ranker of today compares the floats of version 1: only their number is kept.
        const auto floats = reader.get_all<float>(reader.get_count(4));
        if (!all_finite(floats)) return corrupt_blob(kGlobalsBlob, "a number that is not finite");
        global.values.assign(floats.size(), 0);
    }
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kGlobalsBlob, "wrong length");
    return globals;
}

std::string encode_signature(const std::vector<float>& signature) {
    return encode_floats(kSignatureBlob, signature);
}

Result<std::vector<float>> decode_signature(std::string_view blob) {
    const auto payload = open_blob(kSignatureBlob, blob);
    if (!payload) return payload.error();
    ByteReader reader(*payload);
    std::vector<float> signature = reader.get_all<float>(reader.get_count(4));
    if (!reader.ok() || !reader.at_end()) return corrupt_blob(kSignatureBlob, "wrong length");
    if (!all_finite(signature)) return corrupt_blob(kSignatureBlob, "a number that is not finite");
    return signature;
}

std::string encode_thumbnail(const std::vector<std::uint8_t>& png) {
    const std::string bytes(png.begin(), png.end());
    return seal_blob(kThumbnailBlob, bytes);
}

Result<std::vector<std::uint8_t>> decode_thumbnail(std::string_view blob) {
    const auto payload = open_blob(kThumbnailBlob, blob);
    if (!payload) return payload.error();
    if (payload->substr(0, 8) != "\x89PNG\r\n\x1a\n") {
        return corrupt_blob(kThumbnailBlob, "not a PNG picture");
    }
    return std::vector<std::uint8_t>(payload->begin(), payload->end());
}

}  // namespace ossuary::index
