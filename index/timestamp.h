#pragma once

#include <string>

namespace ossuary::index {

/// The time now as ISO 8601 in UTC to the second: 2026-01-01T00:00:00Z.
[[nodiscard]] std::string utc_now();

}  // namespace ossuary::index
