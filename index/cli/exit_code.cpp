#include "index/cli/exit_code.h"

namespace ossuary::cli {

ExitCode exit_code_for(ErrorCode code) {
    switch (code) {
        case ErrorCode::kIndexNotFound:
        case ErrorCode::kIndexForeign:
        case ErrorCode::kIndexNewer:
        case ErrorCode::kIndexCorrupt:
            return ExitCode::kNotAnIndex;
        case ErrorCode::kInvalidArgument:
            return ExitCode::kUsage;
        default:
            return ExitCode::kFailed;
    }
}

}  // namespace ossuary::cli
