#include "server/request_head.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "server/trim.h"

namespace ossuary::server {
namespace {

using enum RequestFault;

tl::unexpected<Problem> refuse(RequestFault fault, std::string detail) {
    return tl::unexpected<Problem>(problem(fault, std::move(detail)));
}

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

bool is_token(std::string_view text) {
    constexpr std::string_view kOthers = "!#$%&'*+-.^_`|~";
    return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               kOthers.find(c) != std::string_view::npos;
    });
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return -1;
}

/// Whether a comma-separated header value has this element.
bool lists(std::string_view value, std::string_view element) {
    while (!value.empty()) {
        const std::size_t comma = std::min(value.find(','), value.size());
        if (same_name(trim(value.substr(0, comma)), element)) return true;
        value.remove_prefix(std::min(comma + 1, value.size()));
    }
    return false;
}

Checked<Fields> parse_query(std::string_view query) {
    Fields parameters;
    while (!query.empty()) {
        const std::size_t end = std::min(query.find('&'), query.size());
        const std::string_view pair = query.substr(0, end);
        query.remove_prefix(std::min(end + 1, query.size()));
        if (pair.empty()) continue;
        const std::size_t equals = std::min(pair.find('='), pair.size());
        auto name = percent_decode(pair.substr(0, equals), true);
        if (!name) return tl::unexpected<Problem>(std::move(name.error()));
        auto value = percent_decode(pair.substr(std::min(equals + 1, pair.size())), true);
        if (!value) return tl::unexpected<Problem>(std::move(value.error()));
        parameters.push_back({*std::move(name), *std::move(value)});
    }
    return parameters;
}

/// `target` is `/path?query`, or `http://authority/path?query`, whose authority replaces Host.
Checked<void> parse_target(std::string_view target, RequestHead& head) {
    constexpr std::string_view kScheme = "http://";
    if (target == "*" && head.method == "OPTIONS") {
        head.path = target;
        return {};
    }
    if (target.substr(0, kScheme.size()) == kScheme) {
        target.remove_prefix(kScheme.size());
        const std::size_t slash = std::min(target.find('/'), target.size());
        head.headers.push_back({"Host", std::string(target.substr(0, slash))});
        target.remove_prefix(slash);
    }
    if (target.empty() || target.front() != '/') {
        return refuse(kMalformedRequest, "The request's target must begin with a slash.");
    }
    const std::size_t question = std::min(target.find('?'), target.size());
    const std::string_view path = target.substr(0, question);
    for (std::size_t i = 0; i + 2 < path.size(); ++i) {
        // Decoded, these would make other segments than the client wrote.
        const std::string_view escape = path.substr(i, 3);
        if (same_name(escape, "%2f") || same_name(escape, "%5c")) {
            return refuse(kBadEscape, "The path has an encoded slash.");
        }
    }
    auto decoded = percent_decode(path, false);
    if (!decoded) return tl::unexpected<Problem>(std::move(decoded.error()));
    head.path = *std::move(decoded);
    auto parameters = parse_query(target.substr(std::min(question + 1, target.size())));
    if (!parameters) return tl::unexpected<Problem>(std::move(parameters.error()));
    head.parameters = *std::move(parameters);
    return {};
}

Checked<void> parse_request_line(std::string_view line, const HeadLimits& limits,
                                 RequestHead& head) {
    const std::size_t first = line.find(' ');
    const std::size_t last = line.rfind(' ');
    if (first == std::string_view::npos || first == last) {
        return refuse(kMalformedRequest, "The request line must be: method, target, version.");
    }
    const std::string_view method = line.substr(0, first);
    const std::string_view target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    if (!is_token(method) || method.size() > 32) {
        return refuse(kMalformedRequest, "The method is not a word.");
    }
    if (target.size() > limits.max_target) {
        return refuse(kUriTooLong, "The address has " + std::to_string(target.size()) +
                                       " bytes; at most " + std::to_string(limits.max_target) +
                                       " are taken.");
    }
    const bool visible = std::all_of(target.begin(), target.end(),
                                     [](char c) { return c > 0x20 && c < 0x7f && c != '#'; });
    if (target.empty() || !visible) {
        return refuse(kMalformedRequest, "The address has bytes that must be percent-encoded.");
    }
    if (version != "HTTP/1.1" && version != "HTTP/1.0") {
        if (version.substr(0, 5) == "HTTP/") {
            return refuse(kVersionUnsupported, "Only HTTP/1.1 and HTTP/1.0 are spoken here.");
        }
        return refuse(kMalformedRequest, "The request line must end with HTTP/1.1.");
    }
    head.method = method;
    head.minor_version = version.back() - '0';
    return parse_target(target, head);
}

Checked<Field> parse_field(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) {
        return refuse(kMalformedRequest, "A header field must be: name, colon, value.");
    }
    const std::string_view value = trim(line.substr(colon + 1));
    const bool control =
        std::any_of(value.begin(), value.end(), [](char c) { return is_control(c) && c != '\t'; });
    if (control) {
        return refuse(kControlCharacters, "A header field's value has control characters.");
    }
    return Field{std::string(line.substr(0, colon)), std::string(value)};
}

std::size_t count_fields(const Fields& fields, std::string_view name) {
    return static_cast<std::size_t>(
        std::count_if(fields.begin(), fields.end(),
                      [&](const Field& field) { return same_name(field.name, name); }));
}

Checked<void> judge_body_length(RequestHead& head) {
    const std::string* length = find_field(head.headers, "Content-Length");
    if (count_fields(head.headers, "Transfer-Encoding") > 0) {
        if (length != nullptr) {
            return refuse(kAmbiguousLength,
                          "Content-Length and Transfer-Encoding contradict each other.");
        }
        return refuse(kLengthRequired,
                      "Transfer-Encoding is not taken; send the body with a Content-Length.");
    }
    if (count_fields(head.headers, "Content-Length") > 1) {
        return refuse(kAmbiguousLength, "Content-Length is given more than once.");
    }
    if (length != nullptr) {
        const char* end = length->data() + length->size();
        const auto [stop, fault] = std::from_chars(length->data(), end, head.content_length);
        if (length->empty() || stop != end || fault != std::errc()) {
            return refuse(kAmbiguousLength, "Content-Length must be one whole number.");
        }
    }
    const std::string encoding = head.header("Content-Encoding");
    if (!encoding.empty() && !same_name(encoding, "identity")) {
        return refuse(kContentEncodingUnsupported, "Send the body without Content-Encoding.");
    }
    return {};
}

Checked<void> judge_fields(RequestHead& head) {
    const std::size_t hosts = count_fields(head.headers, "Host");
    if (hosts > 1) return refuse(kMalformedRequest, "Host is given more than once.");
    if (hosts == 0 && head.minor_version == 1) {
        return refuse(kMalformedRequest, "Host is missing.");
    }
    if (auto judged = judge_body_length(head); !judged) return judged;

    const std::string expect = head.header("Expect");
    if (!expect.empty()) {
        if (!same_name(expect, "100-continue")) {
            return refuse(kExpectationFailed, "Only 100-continue may be expected.");
        }
        head.expects_continue = head.minor_version == 1;
    }
    const std::string connection = head.header("Connection");
    head.keep_alive =
        head.minor_version == 1 ? !lists(connection, "close") : lists(connection, "keep-alive");
    return {};
}

}  // namespace

Checked<RequestHead> check_head(std::string_view raw, const HeadLimits& limits) {
    constexpr std::string_view kLineEnd = "\r\n";
    RequestHead head;
    Fields fields;
    bool request_line = true;
    while (true) {
        const std::size_t end = raw.find(kLineEnd);
        const std::string_view line = raw.substr(0, end);
        if (end == std::string_view::npos || line.find_first_of(kLineEnd) != line.npos) {
            return refuse(kMalformedRequest, "Each line of the header must end with CR LF.");
        }
        raw.remove_prefix(end + kLineEnd.size());
        if (line.empty() && !request_line) break;
        if (request_line) {
            if (auto parsed = parse_request_line(line, limits, head); !parsed) {
                return tl::unexpected<Problem>(std::move(parsed.error()));
            }
            request_line = false;
            continue;
        }
        if (line.front() == ' ' || line.front() == '\t') {
            return refuse(kMalformedRequest, "Folded header lines are not taken.");
        }
        if (fields.size() == limits.max_fields) {
            return refuse(
                kTooManyFields,
                "There are more than " + std::to_string(limits.max_fields) + " header fields.");
        }
        auto field = parse_field(line);
        if (!field) return tl::unexpected<Problem>(std::move(field.error()));
        fields.push_back(*std::move(field));
    }
    if (!head.headers.empty()) {  // the authority of an absolute target
        std::erase_if(fields, [](const Field& field) { return same_name(field.name, "Host"); });
    }
    head.headers.insert(head.headers.end(), std::make_move_iterator(fields.begin()),
                        std::make_move_iterator(fields.end()));
    if (auto judged = judge_fields(head); !judged) {
        return tl::unexpected<Problem>(std::move(judged.error()));
    }
    return head;
}

std::string loggable_target(std::string_view raw) {
    const std::string_view line = raw.substr(0, std::min(raw.find_first_of("\r\n"), raw.size()));
    std::string text(line.substr(0, 200));
    for (char& c : text) {
        if (c < 0x20 || c >= 0x7f) c = '?';
    }
    return text;
}

Checked<std::string> percent_decode(std::string_view text, bool plus_is_space) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '+' && plus_is_space) c = ' ';
        if (c == '%') {
            const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
            const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
            if (high < 0 || low < 0) {
                return refuse(kBadEscape, "A percent sign must be followed by two hex digits.");
            }
            c = static_cast<char>(high * 16 + low);
            i += 2;
        }
        if (is_control(c)) {
            return refuse(kControlCharacters, "The address has control characters.");
        }
        decoded.push_back(c);
    }
    if (!is_utf8(decoded)) return refuse(kBadEscape, "The address is not UTF-8 when decoded.");
    return decoded;
}

bool is_utf8(std::string_view text) {
    std::size_t i = 0;
    while (i < text.size()) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        if (lead < 0x80) continue;
        const int more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
        if (lead < 0xc2 || lead > 0xf4) return false;
        std::uint32_t point = lead & (0x3fu >> more);
        for (int k = 0; k < more; ++k) {
            if (i == text.size()) return false;
            const auto byte = static_cast<unsigned char>(text[i++]);
            if ((byte & 0xc0u) != 0x80u) return false;
            point = point << 6 | (byte & 0x3fu);
        }
        const std::uint32_t least = more == 3 ? 0x10000 : more == 2 ? 0x800 : 0x80;
        if (point < least || point > 0x10ffff || (point >= 0xd800 && point <= 0xdfff)) return false;
    }
    return true;
}

}  // namespace ossuary::server
