#pragma once

#include <string_view>

namespace ossuary::server {

/// Without blanks and tabs at both ends: the optional white space of RFC 9110, sec. 5.6.3.
inline std::string_view trim(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

}  // namespace ossuary::server
