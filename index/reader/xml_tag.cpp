#include "index/reader/xml_tag.h"

namespace ossuary::index {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

bool is_space(char c) { return kSpace.find(c) != std::string_view::npos; }

}  // namespace

std::string_view xml_attribute(std::string_view tag, std::string_view name) {
    for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at)) {
        const bool begins = at > 0 && is_space(tag[at - 1]);
        at += name.size();
        const std::size_t equals = tag.find_first_not_of(kSpace, at);
        if (!begins || equals == std::string_view::npos || tag[equals] != '=') continue;
        const std::size_t quote = tag.find_first_of("\"'", equals);
        if (quote == std::string_view::npos) return {};
        const std::size_t end = tag.find(tag[quote], quote + 1);
        if (end == std::string_view::npos) return {};
        return tag.substr(quote + 1, end - quote - 1);
    }
    return {};
}

std::string_view first_tag(std::string_view document, std::string_view name) {
    for (std::size_t at = document.find('<'); at != std::string_view::npos;
         at = document.find('<', at)) {
        const std::string_view rest = document.substr(++at);
        if (!rest.starts_with(name) || rest.size() == name.size()) continue;
        const char after = rest[name.size()];
        if (is_space(after) || after == '>' || after == '/') return rest.substr(0, rest.find('>'));
    }
    return {};
}

}  // namespace ossuary::index
