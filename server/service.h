#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "index/model_reader.h"
#include "index/searcher.h"
#include "server/auth.h"
#include "server/evaluations.h"
#include "server/jobs.h"
#include "server/log.h"
#include "server/metrics.h"
#include "server/options.h"
#include "server/progress.h"
#include "server/queries.h"
#include "server/slots.h"
#include "server/static_files.h"
#include "server/statistics_updater.h"

namespace ossuary::server {

/// What handlers work with. Made once, in `main`, and outlives every request.
struct Service {
    const ServerOptions& options;
    Log& log;
    Metrics& metrics;
    index::Searcher& searcher;
    index::ModelReader& reader;
    Slots& slots;  ///< for whatever keeps a processor busy
    Evaluations& evaluations;
    Queries& queries;
    Progress& progress;
    const StaticFiles& files;
    Key admin_key;  ///< without one administration is off, then there are neither of the two below
    Key read_key;   ///< without one everybody may read
    std::unique_ptr<StatisticsUpdater> statistics;
    std::unique_ptr<Jobs> jobs;
    std::string instance;  ///< differs at each start; part of some entity tags
    std::atomic<bool> draining = false;
};

}  // namespace ossuary::server
