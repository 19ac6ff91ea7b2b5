#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "engine/mesh/parse_number.h"

namespace ossuary::mesh {

/// Walks through the text of a model file and counts its lines. Lines end with LF, CR LF or a lone
/// CR; `#` starts a comment that lasts to the end of its line.
class TextScanner {
public:
    explicit TextScanner(std::string_view text)
        : position_(text.data()), end_(text.data() + text.size()) {}

    [[nodiscard]] std::size_t line() const { return line_; }
    [[nodiscard]] std::size_t bytes_left() const {
        return static_cast<std::size_t>(end_ - position_);
    }

    /// Moves over the mark that UTF-8 text may begin with.
    void skip_byte_order_mark() {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (std::string_view(position_, bytes_left()).starts_with(kByteOrderMark)) {
            position_ += kByteOrderMark.size();
        }
    }

    /// Skips blanks and comments; true when nothing else is left on this line.
    bool at_line_end() {
        while (position_ != end_ && is_blank(*position_)) ++position_;
        if (position_ != end_ && *position_ == '#') skip_rest_of_line();
        return position_ == end_ || is_newline(*position_);
    }

    /// Moves to the next token, over as many lines as it takes; false at the end of the text.
    bool find_token() {
        while (at_line_end()) {
            if (position_ == end_) return false;
            step_over_newline();
        }
        return true;
    }

    void skip_rest_of_line() {
        while (position_ != end_ && !is_newline(*position_)) ++position_;
    }

    void skip_line() {
        skip_rest_of_line();
        if (position_ != end_) step_over_newline();
    }

    /// The token at the current position, up to a blank, a comment or the end of the line.
    [[nodiscard]] std::string_view peek_token() const {
        const char* p = position_;
        while (p != end_ && !is_delimiter(*p)) ++p;
        return {position_, static_cast<std::size_t>(p - position_)};
    }
    /// Moves over the next `count` bytes of the current line.
    void advance(std::size_t count) { position_ += count; }

    /// Reads the number at the current position and moves behind it; stays where it is on failure.
    NumberStatus read_double(double& value) {
        const ParsedNumber<double> parsed = parse_double(position_, end_);
        if (parsed.status != NumberStatus::kOk) return parsed.status;
        if (parsed.end != end_ && !is_delimiter(*parsed.end)) return NumberStatus::kNotANumber;
        position_ = parsed.end;
        value = parsed.value;
        return NumberStatus::kOk;
    }

    /// The same for a non-negative integer.
    NumberStatus read_count(std::uint64_t& value) {
        const char* p = position_;
        if (p != end_ && *p == '+') ++p;
        const char* const digits = p;
        std::uint64_t read = 0;
        while (p != end_ && static_cast<unsigned char>(*p - '0') < 10) {
            if (read > (std::numeric_limits<std::uint64_t>::max() - 9) / 10) {
                return NumberStatus::kTooLarge;
            }
            read = read * 10 + static_cast<std::uint64_t>(*p - '0');
            ++p;
        }
        if (p == digits || (p != end_ && !is_delimiter(*p))) return count_failure();
        position_ = p;
        value = read;
        return NumberStatus::kOk;
    }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool is_newline(char c) { return c == '\n' || c == '\r'; }
    static bool is_delimiter(char c) { return is_blank(c) || is_newline(c) || c == '#'; }

    void step_over_newline() {
        if (*position_ == '\r' && position_ + 1 != end_ && position_[1] == '\n') ++position_;
        ++position_;
        ++line_;
    }
    [[nodiscard]] NumberStatus count_failure() const;

    const char* position_;
    const char* end_;
    std::size_t line_ = 1;
};

/// Whether a text is a word in capitals, written in any case.
[[nodiscard]] bool spells(std::string_view text, std::string_view capitals);

/// A token as it can be shown in a message: quoted, shortened, without control characters.
[[nodiscard]] std::string quoted_token(std::string_view token);

}  // namespace ossuary::mesh
