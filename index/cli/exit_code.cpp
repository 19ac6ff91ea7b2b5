#include "index/cli/exit_code.h"

#include "index/store.h"

namespace ossuary::cli {

ExitCode exit_code_for(ErrorCode code) {
    if (index::is_unusable_index(code)) return ExitCode::kNotAnIndex;
    return code == ErrorCode::kInvalidArgument ? ExitCode::kUsage : ExitCode::kFailed;
}

}  // namespace ossuary::cli
