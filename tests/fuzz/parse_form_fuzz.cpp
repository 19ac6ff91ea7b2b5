// Feeds arbitrary bytes to the parser of forms: the first line is the content type, the rest the
// body.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "server/multipart.h"
#include "tests/fuzz/require.h"

namespace {

using ossuary::fuzz::require;

bool is_within(std::string_view part, std::string_view whole) {
    return part.empty() || (part.data() >= whole.data() &&
                            part.data() + part.size() <= whole.data() + whole.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::size_t line = std::min(input.find('\n'), input.size());
    const std::string_view body = input.substr(std::min(line + 1, input.size()));
    const auto parts = ossuary::server::parse_form(input.substr(0, line), body);
    if (!parts) {
        require(parts.error().row.status >= 400 && parts.error().row.status < 500);
        return 0;
    }
    require(parts->size() <= 32);
    for (const auto& part : *parts) {
        require(is_within(part.content, body));
        require(part.file_name.find('/') == std::string_view::npos);
    }
    return 0;
}
