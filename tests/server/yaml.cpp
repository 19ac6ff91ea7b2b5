#include "tests/server/yaml.h"

#include <charconv>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ossuary::test {
namespace {

using nlohmann::json;

struct Line {
    std::size_t number;
    std::size_t indent;
    std::string text;
};

json plain(const std::string& text) {
    if (text == "null" || text == "~") return nullptr;
    if (text == "true") return true;
    if (text == "false") return false;
    const char* end = text.data() + text.size();
    std::int64_t whole = 0;
    if (const auto r = std::from_chars(text.data(), end, whole);
        r.ptr == end && r.ec == std::errc())
        return whole;
    double number = 0;
    if (const auto r = std::from_chars(text.data(), end, number);
        r.ptr == end && r.ec == std::errc())
        return number;
    return text;
}

/// One-line values and flow collections.
class FlowReader {
public:
    FlowReader(std::string_view text, std::size_t line) : text_(text), line_(line) {}

    json value(std::string_view stops) {
        skip();
        if (at_ >= text_.size()) fail("a value is missing");
        const char c = text_[at_];
        if (c == '{') return mapping();
        if (c == '[') return sequence();
        if (c == '\'' || c == '"') return quoted();
        std::string scalar;
        while (at_ < text_.size() && stops.find(text_[at_]) == stops.npos) scalar += text_[at_++];
        while (!scalar.empty() && scalar.back() == ' ') scalar.pop_back();
        return plain(scalar);
    }
    void finish() {
        skip();
        if (at_ != text_.size()) fail("text after a value");
    }

private:
    json mapping() {
        json out = json::object();
        ++at_;
        for (skip(); peek() != '}'; skip()) {
            const json key = value(":,}");
            skip();
            if (peek() != ':') fail("a colon is missing");
            ++at_;
            out[key.is_string() ? key.get<std::string>() : key.dump()] = value(",}");
            skip();
            if (peek() == ',') ++at_;
        }
        ++at_;
        return out;
    }
    json sequence() {
        json out = json::array();
        ++at_;
        for (skip(); peek() != ']'; skip()) {
            out.push_back(value(",]"));
            skip();
            if (peek() == ',') ++at_;
        }
        ++at_;
        return out;
    }
    std::string quoted() {
        const char quote = text_[at_++];
        std::string out;
        while (peek() != quote) out += text_[at_++];
        ++at_;
        return out;
    }
    void skip() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    [[nodiscard]] char peek() const {
        if (at_ >= text_.size()) fail("the text ends within a value");
        return text_[at_];
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error("line " + std::to_string(line_) + ": " + what);
    }

    std::string_view text_;
    std::size_t line_;
    std::size_t at_ = 0;
};

class BlockReader {
public:
    explicit BlockReader(std::string_view text) {
        std::size_t number = 0;
        while (!text.empty()) {
            const std::string_view line = text.substr(0, text.find('\n'));
            text.remove_prefix(std::min(line.size() + 1, text.size()));
            ++number;
            const std::size_t indent = line.find_first_not_of(' ');
            // Empty lines stay: literal blocks have them.
            lines_.push_back({number, indent == line.npos ? 0 : indent,
                              std::string(indent == line.npos ? "" : line.substr(indent))});
        }
    }

    json document() {
        json out = block(0);
        if (more()) fail("text outside the document's structure");
        return out;
    }

private:
    bool more() {
        while (at_ < lines_.size() && lines_[at_].text.empty()) ++at_;
        return at_ < lines_.size();
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error("line " + std::to_string(lines_[at_].number) + ": " + what);
    }

    json block(std::size_t indent) {
        if (!more()) return nullptr;
        return lines_[at_].text.starts_with("- ") ? sequence(indent) : mapping(indent);
    }

    json sequence(std::size_t indent) {
        json out = json::array();
        while (more() && lines_[at_].indent == indent && lines_[at_].text.starts_with("- ")) {
            Line& line = lines_[at_];
            line.text.erase(0, 2);
            line.indent += 2;
            if (split_key(line.text)) {
                out.push_back(mapping(indent + 2));
            } else {
                out.push_back(inline_value(line.text));
            }
        }
        return out;
    }

    json mapping(std::size_t indent) {
        json out = json::object();
        while (more() && lines_[at_].indent == indent && !lines_[at_].text.starts_with("- ")) {
            const auto pair = split_key(lines_[at_].text);
            if (!pair) fail("a key is missing");
            if (out.contains(pair->first)) fail("the key " + pair->first + " is there twice");
            out[pair->first] = value_of(pair->second, indent);
        }
        if (more() && lines_[at_].indent > indent) fail("the indentation does not fit");
        return out;
    }

    json value_of(const std::string& rest, std::size_t indent) {
        if (rest == "|") return literal(indent);
        if (rest.starts_with('*')) {
            ++at_;
            return anchors_.at(rest.substr(1));
        }
        if (!rest.empty() && !rest.starts_with('&')) return inline_value(rest);
        ++at_;
        if (!more() || lines_[at_].indent <= indent) fail("a block is missing");
        json out = block(lines_[at_].indent);
        if (!rest.empty()) anchors_[rest.substr(1)] = out;
        return out;
    }

    json inline_value(std::string text) {
        const std::size_t number = lines_[at_].number;
        const bool flow = text.starts_with('{') || text.starts_with('[');
        ++at_;
        const auto open = [&text] {
            return std::count(text.begin(), text.end(), '[') +
                       std::count(text.begin(), text.end(), '{') >
                   std::count(text.begin(), text.end(), ']') +
                       std::count(text.begin(), text.end(), '}');
        };
        while (flow && open() && more()) text += " " + lines_[at_++].text;
        FlowReader reader(text, number);
        json out = reader.value("");
        reader.finish();
        return out;
    }

    json literal(std::size_t indent) {
        std::string out;
        for (++at_; at_ < lines_.size(); ++at_) {
            if (!lines_[at_].text.empty() && lines_[at_].indent <= indent) break;
            out += lines_[at_].text + "\n";
        }
        return out;
    }

    /// Key and the rest of the line; none when the line is not `key:` or `key: value`.
    static std::optional<std::pair<std::string, std::string>> split_key(const std::string& text) {
        std::size_t colon = 0;
        if (text.starts_with('\'') || text.starts_with('"')) {
            colon = text.find(text[0], 1) + 1;
            if (colon >= text.size() || text[colon] != ':') return std::nullopt;
            const std::string rest = text.substr(std::min(colon + 2, text.size()));
            return std::pair(text.substr(1, colon - 2), rest);
        }
        if (text.ends_with(':') && text.find(' ') == text.npos) {
            return std::pair(text.substr(0, text.size() - 1), std::string());
        }
        colon = text.find(": ");
        if (colon == text.npos || text.substr(0, colon).find(' ') != text.npos) return std::nullopt;
        return std::pair(text.substr(0, colon), text.substr(colon + 2));
    }

    std::vector<Line> lines_;
    std::size_t at_ = 0;
    std::map<std::string, json> anchors_;
};

}  // namespace

nlohmann::json parse_yaml(std::string_view text) { return BlockReader(text).document(); }

}  // namespace ossuary::test
