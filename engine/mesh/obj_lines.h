#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace ossuary::mesh {

/// The lines of an OBJ file, one after the other, each with those that it goes on in: a line that
/// ends with `\` is continued by the next. Lines end with LF, CR LF or a lone CR.
class ObjLines {
public:
    explicit ObjLines(std::string_view text) : text_(text) {}

    /// Moves to the next line; false after the last.
    bool next() {
        if (at_ == text_.size()) return false;
        ++number_;
        number_ += continued_;
        continued_ = 0;
        line_ = take_line();
        if (line_.ends_with('\\') && may_go_on(line_)) join();
        return true;
    }

    /// Without its end; until `next`.
    [[nodiscard]] std::string_view text() const { return line_; }
    /// Of the first of the joined lines, from 1.
    [[nodiscard]] std::size_t number() const { return number_; }

private:
    /// Where the byte comes next, looked for again only once that has been passed, so that a file
    /// is gone through once whatever its lines end with.
    std::size_t find(char newline, std::size_t& found) const {
        if (found < at_ || !looked_for_) found = std::min(text_.find(newline, at_), text_.size());
        return found;
    }

    std::string_view take_line() {
        const std::size_t end = std::min(find('\n', line_feed_), find('\r', carriage_return_));
        looked_for_ = true;
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = std::min(end + 1, text_.size());
        const bool both = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
        if (both) ++at_;
        return line;
    }

    /// Names and comments end with their line: a backslash may be the last letter of a path.
    static bool may_go_on(std::string_view line) {
        constexpr std::string_view kBlanks = " \t";
        line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
        return !word.starts_with('#') && word != "g" && word != "o" && word != "mtllib" &&
               word != "usemtl";
    }

    void join() {
        joined_.assign(line_.substr(0, line_.size() - 1));
        while (at_ < text_.size()) {
            const std::string_view more = take_line();
            ++continued_;
            const bool goes_on = more.ends_with('\\');
            joined_.append(1, ' ').append(more.substr(0, more.size() - (goes_on ? 1 : 0)));
            if (!goes_on) break;
        }
        line_ = joined_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
    std::size_t continued_ = 0;
    bool looked_for_ = false;
    std::size_t line_feed_ = 0;
    std::size_t carriage_return_ = 0;
    std::string_view line_;
    std::string joined_;
};

}  // namespace ossuary::mesh
