#include "server/etag.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace ossuary::server {
namespace {

std::string_view without_weakness(std::string_view tag) {
    return tag.substr(0, 2) == "W/" ? tag.substr(2) : tag;
}

}  // namespace

std::string etag_of(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "W/\"%016llx%016llx\"",
                  static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text.data();
}

bool is_current(const RequestHead& head, std::string_view etag) {
    const std::string list = head.header("If-None-Match");
    std::string_view rest = list;
    while (!rest.empty()) {
        // Our tags have no comma, so a tag with one is not ours, whatever its pieces look like.
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string_view tag = rest.substr(0, comma);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
        while (!tag.empty() && tag.front() == ' ') tag.remove_prefix(1);
        while (!tag.empty() && tag.back() == ' ') tag.remove_suffix(1);
        if (tag == "*" || without_weakness(tag) == without_weakness(etag)) return true;
    }
    return false;
}

Response not_modified(std::string etag) {
    Response response;
    response.status = 304;
    response.set_header("ETag", std::move(etag));
    response.set_header("Cache-Control", "no-cache");
    return response;
}

Response conditional(const RequestHead& head, Response response, std::string etag) {
    if (response.status != 200) return response;
    if (etag.empty()) etag = etag_of(response.body);
    if (is_current(head, etag)) return not_modified(std::move(etag));
    response.set_header("ETag", std::move(etag));
    response.set_header("Cache-Control", "no-cache");
    return response;
}

}  // namespace ossuary::server
