#include "server/message.h"

#include <algorithm>

namespace ossuary::server {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

bool same_name(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

const std::string* find_field(const Fields& fields, std::string_view name) {
    for (const Field& field : fields) {
        if (same_name(field.name, name)) return &field.value;
    }
    return nullptr;
}

std::string RequestHead::header(std::string_view name) const {
    const std::string* value = find_field(headers, name);
    return value == nullptr ? std::string() : *value;
}

Response answer(std::string content_type, std::string body) {
    Response response;
    response.content_type = std::move(content_type);
    response.body = std::move(body);
    return response;
}

}  // namespace ossuary::server
