// Feeds arbitrary bytes to the reader of segmentations; the first byte is the number of faces.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/decomposition/seg_file.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using ossuary::fuzz::require;
    if (size == 0) return 0;
    const std::size_t faces = data[0];
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const auto parsed = ossuary::decomposition::parse_seg(bytes, "input", faces);
    if (!parsed) {
        require(parsed.error().code == ossuary::ErrorCode::kSegInvalid);
        return 0;
    }
    require(parsed->labels.size() == faces);
    for (const std::uint32_t label : parsed->labels) require(label < parsed->parts);
    const std::string written = ossuary::decomposition::to_seg(*parsed);
    const auto again = ossuary::decomposition::parse_seg(written, "written", faces);
    require(again.ok() && *again == *parsed);
    return 0;
}
