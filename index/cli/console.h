#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/core/text.h"

namespace ossuary::cli {

enum class Style { kPlain, kBold, kDim, kError, kWarning };

/// The escape sequence of a style on stderr, or nothing where stderr is no terminal or NO_COLOR is
/// set (no-color.org).
[[nodiscard]] std::string_view style(Style style);

[[nodiscard]] bool stderr_is_terminal();

/// Seconds as people say them: "8 s", "2 min 05 s", "1 h 02 min".
[[nodiscard]] std::string duration_text(double seconds);

/// `value` as terminal_format shows it.
template <typename T>
decltype(auto) for_terminal(const T& value) {
    if constexpr (std::is_convertible_v<const T&, std::string_view>) {
        return terminal_text(value);
    } else {
        return value;
    }
}

/// fmt::format for people: texts among the arguments, which may be anybody's, are shown as
/// terminal_text; line feeds and styles belong into `format`.
template <typename... Args>
[[nodiscard]] std::string terminal_format(
    fmt::format_string<decltype(for_terminal(std::declval<const Args&>()))...> format,
    const Args&... args) {
    return fmt::vformat(format, fmt::make_format_args(for_terminal(args)...));
}

/// Several lines of which parts are anybody's: as terminal_text, but for the line ends.
[[nodiscard]] std::string terminal_lines(std::string_view text);

enum class Align { kLeft, kRight };

/// A table of text whose columns are as wide as their widest cell, for stdout.
class Table {
public:
    struct Column {
        std::string heading;
        Align align = Align::kLeft;
    };
    explicit Table(std::vector<Column> columns);
    /// Cells are shown as terminal_text.
    /// @pre as many cells as columns
    void add_row(std::vector<std::string> cells);
    [[nodiscard]] std::string text() const;

private:
    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace ossuary::cli
