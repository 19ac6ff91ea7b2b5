#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ossuary::cli {

enum class Style { kPlain, kBold, kDim, kError, kWarning };

/// The escape sequence of a style on stderr, or nothing where stderr is no terminal or NO_COLOR is
/// set (no-color.org).
[[nodiscard]] std::string_view style(Style style);

[[nodiscard]] bool stderr_is_terminal();

/// Seconds as people say them: "8 s", "2 min 05 s", "1 h 02 min".
[[nodiscard]] std::string duration_text(double seconds);

enum class Align { kLeft, kRight };

/// A table of text whose columns are as wide as their widest cell, for stdout.
class Table {
public:
    struct Column {
        std::string heading;
        Align align = Align::kLeft;
    };
    explicit Table(std::vector<Column> columns);
    /// @pre as many cells as columns
    void add_row(std::vector<std::string> cells);
    [[nodiscard]] std::string text() const;

private:
    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace ossuary::cli
