#pragma once

#include <cstddef>
#include <stop_token>

#include "engine/core/result.h"
#include "index/indexer.h"
#include "index/store.h"

namespace ossuary::index {

/// Makes the local features of models that were indexed before there were any, from their previews,
/// as they would be made of them today; what is made is kept if it is stopped. Tells the sink where
/// there are any. Returns for how many. Errors: cancelled, those of the store.
Result<std::size_t> add_missing_features(Store& store, int jobs, ProgressSink& sink,
                                         const std::stop_token& stop = {});

}  // namespace ossuary::index
