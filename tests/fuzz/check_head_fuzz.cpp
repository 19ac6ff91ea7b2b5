// Feeds arbitrary bytes to the guard of request heads.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "server/request_head.h"
#include "tests/fuzz/require.h"

namespace {

using ossuary::fuzz::require;
namespace server = ossuary::server;

bool has_control(std::string_view text) {
    return std::ranges::any_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    });
}

/// What the handlers rely on.
void check(const server::RequestHead& head, const server::HeadLimits& limits) {
    require(!head.method.empty() && head.path.starts_with('/'));
    require(head.path.size() <= limits.max_target);
    // The host of an absolute target comes on top of those that were sent.
    require(head.headers.size() <= limits.max_fields + 1);
    require(!has_control(head.path) && server::is_utf8(head.path));
    for (const server::Field& field : head.parameters) {
        require(!has_control(field.name) && !has_control(field.value));
        require(server::is_utf8(field.name) && server::is_utf8(field.value));
    }
    for (const server::Field& field : head.headers) {
        require(!field.name.empty());
        require(field.value.find_first_of("\r\n\0") == std::string::npos);
    }
    require(head.header("transfer-encoding").empty());
    require(head.minor_version == 0 || head.minor_version == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view raw(reinterpret_cast<const char*>(data), size);
    const server::HeadLimits limits{.max_bytes = 2048, .max_target = 512, .max_fields = 16};
    if (const auto head = server::check_head(raw, limits)) {
        check(*head, limits);
    } else {
        require(head.error().row.status >= 400 && head.error().row.status < 600);
        require(!has_control(server::loggable_target(raw)));
    }
    return 0;
}
