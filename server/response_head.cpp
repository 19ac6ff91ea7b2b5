#include "server/response_head.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>

namespace ossuary::server {
namespace {

std::string_view reason_phrase(int status) {
    struct Phrase {
        int status;
        std::string_view text;
    };
    constexpr std::array kPhrases = {
        Phrase{200, "OK"},
        Phrase{202, "Accepted"},
        Phrase{204, "No Content"},
        Phrase{304, "Not Modified"},
        Phrase{400, "Bad Request"},
        Phrase{401, "Unauthorized"},
        Phrase{403, "Forbidden"},
        Phrase{404, "Not Found"},
        Phrase{405, "Method Not Allowed"},
        Phrase{408, "Request Timeout"},
        Phrase{411, "Length Required"},
        Phrase{413, "Content Too Large"},
        Phrase{414, "URI Too Long"},
        Phrase{415, "Unsupported Media Type"},
        Phrase{417, "Expectation Failed"},
        Phrase{421, "Misdirected Request"},
        Phrase{422, "Unprocessable Content"},
        Phrase{431, "Request Header Fields Too Large"},
        Phrase{500, "Internal Server Error"},
        Phrase{501, "Not Implemented"},
        Phrase{503, "Service Unavailable"},
        Phrase{505, "HTTP Version Not Supported"},
    };
    const auto found = std::find_if(kPhrases.begin(), kPhrases.end(),
                                    [&](const Phrase& each) { return each.status == status; });
    return found == kPhrases.end() ? std::string_view() : found->text;
}

std::string http_date() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    constexpr std::array kDays = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
    constexpr std::array kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                    "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    std::array<char, 40> text{};
    const int size = std::snprintf(text.data(), text.size(), "%s, %02d %s %04d %02d:%02d:%02d GMT",
                                   kDays[static_cast<std::size_t>(utc.tm_wday)], utc.tm_mday,
                                   kMonths[static_cast<std::size_t>(utc.tm_mon)],
                                   utc.tm_year + 1900, utc.tm_hour, utc.tm_min, utc.tm_sec);
    return {text.data(), static_cast<std::size_t>(size)};
}

void append(std::string& text, std::string_view name, std::string_view value) {
    text.append(name).append(": ").append(value).append("\r\n");
}

}  // namespace

std::string response_head(const Response& response, std::size_t body_size, const Fields& fields) {
    std::string text = "HTTP/1.1 " + std::to_string(response.status) + " ";
    text.append(reason_phrase(response.status)).append("\r\n");
    append(text, "Date", http_date());
    for (const Field& field : response.headers) append(text, field.name, field.value);
    if (!response.content_type.empty()) append(text, "Content-Type", response.content_type);
    for (const Field& field : fields) append(text, field.name, field.value);
    if (response.status != 204 && response.status != 304) {
        append(text, "Content-Length", std::to_string(body_size));
    }
    return text.append("\r\n");
}

bool takes_gzip(std::string_view accept_encoding) {
    const std::size_t at = accept_encoding.find("gzip");
    return at != std::string_view::npos && accept_encoding.compare(at, 8, "gzip;q=0") != 0;
}

bool is_compressible(std::string_view content_type) {
    const std::string_view type = content_type.substr(0, content_type.find(';'));
    return type.starts_with("text/") || type == "application/json" || type == "image/svg+xml" ||
           type == "application/yaml" || type == "application/javascript";
}

}  // namespace ossuary::server
