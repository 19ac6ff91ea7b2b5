#pragma once

#include "engine/core/result.h"

namespace ossuary::cli {

/// What the program's exit status says; scripts depend on the numbers.
enum class ExitCode {
    kDone = 0,
    kFailed = 1,
    kUsage = 2,
    kSomeModelsFailed = 3,
    kNotAnIndex = 4,
};

/// The status for an error that ended a command: 4 when the index cannot be used, else 1.
[[nodiscard]] ExitCode exit_code_for(ErrorCode code);

}  // namespace ossuary::cli
