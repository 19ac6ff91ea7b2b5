#pragma once

#include <string>
#include <string_view>

#include "index/evaluation.h"

// How reports write numbers and text.

namespace ossuary::index {

/// Text between tags or in an attribute of HTML or SVG; always well-formed XML 1.0.
[[nodiscard]] std::string markup_text(std::string_view text);

/// One field of a comma-separated line, quoted where need be.
[[nodiscard]] std::string csv_field(std::string_view text);

/// With this many digits after the point.
[[nodiscard]] std::string fixed(double value, int digits);

/// With as few digits as give the same number back.
[[nodiscard]] std::string shortest(double value);

/// "hybrid", "hybrid, re-ranked"
[[nodiscard]] std::string evaluation_title(const Evaluation& evaluation);

}  // namespace ossuary::index
