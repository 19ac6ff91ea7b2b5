#include "server/multipart.h"

#include <algorithm>
#include <optional>

#include "server/trim.h"

namespace ossuary::server {
namespace {

constexpr std::size_t kMaxParts = 32;
constexpr std::size_t kMaxPartHeader = 4096;

tl::unexpected<Problem> refuse(std::string detail) {
    return tl::unexpected<Problem>(problem(RequestFault::kMultipartInvalid, std::move(detail)));
}

/// The parameters after the first `;` of a header value: name=value or name="value".
std::optional<Fields> header_parameters(std::string_view value) {
    Fields parameters;
    std::size_t i = std::min(value.find(';'), value.size());
    while (i < value.size()) {
        ++i;  // the semicolon
        const std::size_t equals = value.find_first_of("=;", i);
        if (equals == std::string_view::npos || value[equals] == ';') {
            if (trim(value.substr(i, equals - i)).empty()) {
                i = std::min(equals, value.size());
                continue;
            }
            return std::nullopt;
        }
        Field field{std::string(trim(value.substr(i, equals - i))), {}};
        i = equals + 1;
        if (i < value.size() && value[i] == '"') {
            ++i;
            while (i < value.size() && value[i] != '"') {
                if (value[i] == '\\' && i + 1 < value.size()) ++i;
                field.value.push_back(value[i++]);
            }
            if (i == value.size()) return std::nullopt;
            i = std::min(value.find(';', i), value.size());
        } else {
            const std::size_t end = std::min(value.find(';', i), value.size());
            field.value = trim(value.substr(i, end - i));
            i = end;
        }
        parameters.push_back(std::move(field));
    }
    return parameters;
}

std::string without_folders(std::string_view name) {
    const std::size_t slash = name.find_last_of("/\\");
    return std::string(slash == std::string_view::npos ? name : name.substr(slash + 1));
}

/// Fills name and file name from a part's header lines.
Checked<FormPart> parse_part_header(std::string_view header) {
    FormPart part;
    bool disposed = false;
    while (!header.empty()) {
        const std::size_t end = std::min(header.find("\r\n"), header.size());
        const std::string_view line = header.substr(0, end);
        header.remove_prefix(std::min(end + 2, header.size()));
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) return refuse("A part's header has no colon.");
        if (!same_name(line.substr(0, colon), "Content-Disposition")) continue;
        const std::string_view value = trim(line.substr(colon + 1));
        const auto parameters = header_parameters(value);
        if (media_type(value) != "form-data" || !parameters || disposed) {
            return refuse("A part's Content-Disposition is not that of a form.");
        }
        disposed = true;
        if (const auto* name = find_field(*parameters, "name")) part.name = *name;
        if (const auto* name = find_field(*parameters, "filename")) {
            part.file_name = without_folders(*name);
        }
    }
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    };
    const std::string names = part.name + part.file_name;
    if (part.name.empty()) return refuse("A part has no name.");
    if (!is_utf8(names) || std::any_of(names.begin(), names.end(), is_control)) {
        return refuse("A part's name is not plain UTF-8 text.");
    }
    return part;
}

}  // namespace

std::string media_type(std::string_view content_type) {
    std::string type(trim(content_type.substr(0, content_type.find(';'))));
    for (char& c : type) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return type;
}

Checked<std::vector<FormPart>> parse_form(std::string_view content_type, std::string_view body) {
    const auto parameters = header_parameters(content_type);
    const std::string* boundary = parameters ? find_field(*parameters, "boundary") : nullptr;
    if (boundary == nullptr || boundary->empty() || boundary->size() > 70) {
        return refuse("The Content-Type has no usable boundary.");
    }
    const std::string delimiter = "\r\n--" + *boundary;
    const std::string_view first = std::string_view(delimiter).substr(2);
    std::size_t at = 0;
    if (body.substr(0, first.size()) == first) {
        at = first.size();
    } else {  // a preamble
        at = body.find(delimiter);
        if (at == std::string_view::npos) return refuse("The body does not have its boundary.");
        at += delimiter.size();
    }
    std::vector<FormPart> parts;
    while (body.substr(at, 2) != "--") {
        if (body.substr(at, 2) != "\r\n")
            return refuse("A boundary is not followed by a line end.");
        if (parts.size() == kMaxParts) return refuse("The form has too many parts.");
        at += 2;
        const std::size_t header_end = body.substr(at, kMaxPartHeader).find("\r\n\r\n");
        if (header_end == std::string_view::npos) return refuse("A part's header does not end.");
        auto part = parse_part_header(body.substr(at, header_end));
        if (!part) return tl::unexpected<Problem>(std::move(part.error()));
        at += header_end + 4;
        const std::size_t end = body.find(delimiter, at);
        if (end == std::string_view::npos) return refuse("The form's last boundary is missing.");
        part->content = body.substr(at, end - at);
        parts.push_back(*std::move(part));
        at = end + delimiter.size();
    }
    return parts;
}

}  // namespace ossuary::server
