// Feeds arbitrary bytes to the unpacker of gzip data.

#include <cstdint>
#include <string_view>

#include "engine/core/inflate.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using ossuary::fuzz::require;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    ossuary::UnpackCaps caps;
    caps.max_bytes = 1 << 20;
    const auto unpacked = ossuary::gunzip(bytes, "input", caps);
    if (unpacked) {
        require(unpacked->size() <= caps.max_bytes);
    } else {
        require(unpacked.error().code == ossuary::ErrorCode::kGzipInvalid ||
                unpacked.error().code == ossuary::ErrorCode::kFileTooLarge);
    }
    return 0;
}
