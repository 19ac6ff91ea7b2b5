#include "index/blob.h"

#include <xxhash.h>

#include <cassert>

#include "index/bytes.h"

namespace ossuary::index {

std::string seal_blob(const BlobKind& kind, std::string_view payload) {
    assert(kind.mark.size() == 4);
    ByteWriter writer;
    writer.put_raw(kind.mark);
    writer.put(kind.version);
    writer.put_raw(std::string_view("\0\0\0", 3));
    writer.put_raw(payload);
    writer.put(
        static_cast<std::uint64_t>(XXH3_64bits(writer.bytes().data(), writer.bytes().size())));
    return std::move(writer).take();
}

Result<std::string_view> open_blob(const BlobKind& kind, std::string_view blob) {
    const std::string what = std::string(kind.mark) + " blob";
    if (blob.size() < kBlobHeaderSize + kBlobTrailerSize) {
        return {ErrorCode::kIndexCorrupt, what + ": " + std::to_string(blob.size()) +
                                              " bytes, expected at least " +
                                              std::to_string(kBlobHeaderSize + kBlobTrailerSize)};
    }
    const std::string_view sealed = blob.substr(0, blob.size() - kBlobTrailerSize);
    ByteReader trailer(blob.substr(sealed.size()));
    if (trailer.get<std::uint64_t>() != XXH3_64bits(sealed.data(), sealed.size())) {
        return {ErrorCode::kIndexCorrupt, what + ": checksum does not match"};
    }
    if (sealed.substr(0, 4) != kind.mark) {
        return {ErrorCode::kIndexCorrupt, what + ": marked as another kind of blob"};
    }
    const auto version = static_cast<std::uint8_t>(sealed[4]);
    if (version > kind.version) {
        return {ErrorCode::kIndexNewer, what + ": version " + std::to_string(version) +
                                            ", this program reads up to " +
                                            std::to_string(kind.version)};
    }
    if (version == 0 || sealed.substr(5, 3) != std::string_view("\0\0\0", 3)) {
        return {ErrorCode::kIndexCorrupt, what + ": header not understood"};
    }
    return sealed.substr(kBlobHeaderSize);
}

std::uint8_t blob_version(std::string_view blob) {
    assert(blob.size() >= kBlobHeaderSize);
    return static_cast<std::uint8_t>(blob[4]);
}

Error corrupt_blob(const BlobKind& kind, std::string_view what) {
    return {ErrorCode::kIndexCorrupt, std::string(kind.mark) + " blob: " + std::string(what)};
}

}  // namespace ossuary::index
