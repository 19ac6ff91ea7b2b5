#pragma once

#include <string>
#include <string_view>

namespace ossuary::index {

/// Names a piece of work of this process for those that come after it: the machine's boot, the
/// process, and a number that no other mark of the process has.
[[nodiscard]] std::string process_mark();

/// Whether the process that made the mark still runs on this machine.
[[nodiscard]] bool process_runs(std::string_view mark);

}  // namespace ossuary::index
