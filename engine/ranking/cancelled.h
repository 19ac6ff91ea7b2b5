#pragma once

#include "engine/core/result.h"

namespace ossuary::ranking {

/// What every function of the ranker answers once it was asked to stop.
inline Error cancelled() { return {ErrorCode::kCancelled, "ranking was given up"}; }

}  // namespace ossuary::ranking
