#include "server/server.h"

#include <random>
#include <thread>

#include "engine/core/parallel.h"
#include "server/application.h"
#include "server/auth.h"
#include "server/index_watch.h"
#include "server/service.h"

namespace ossuary::server {
namespace {

std::string random_word() {
    std::random_device random;
    return std::to_string(random()) + "-" + std::to_string(random());
}

/// What is there before a server is.
struct Opened {
    Key admin_key, read_key;
    StaticFiles files;
    index::Searcher searcher;
};

Result<Opened> open_all(const ServerOptions& options) {
    auto admin_key = Key::load(options.admin_key_file, "OSSUARY_ADMIN_KEY", "administrator's key");
    if (!admin_key) return admin_key.error();
    auto read_key = Key::load(options.read_key_file, "OSSUARY_READ_KEY", "readers' key");
    if (!read_key) return read_key.error();
    // Before the index: a file that is read while a store has it open costs the store its locks.
    StaticFiles files;
    if (!options.web.empty()) {
        auto loaded = StaticFiles::load(options.web);
        if (!loaded) return loaded.error();
        files = *std::move(loaded);
    }
    std::error_code fault;
    if (options.create && !std::filesystem::exists(options.index, fault)) {
        const auto created = index::Store::create_or_open(options.index, {});
        if (!created) return created.error();
    }
    auto searcher = index::Searcher::open(options.index);
    if (!searcher) return searcher.error();
    return Opened{*std::move(admin_key), *std::move(read_key), std::move(files),
                  *std::move(searcher)};
}

}  // namespace

/// In the order of construction; what requests use outlives the HTTP server.
struct Server::Parts {
    Parts(const ServerOptions& chosen, index::Searcher opened, StaticFiles gallery)
        : options(chosen),
          log(options.log),
          searcher(std::move(opened)),
          files(std::move(gallery)),
          slots(static_cast<std::size_t>(resolve_jobs(static_cast<int>(options.searches))),
                options.searches_waiting),
          evaluations(evaluate_over(options.index), {.models = options.evaluation_models}, log),
          queries({.bytes = options.kept_queries_bytes}),
          service{options,  log,   metrics, searcher, reader,  slots,   evaluations,  queries,
                  progress, files, Key(),   Key(),    nullptr, nullptr, random_word()},
          watch(searcher, log),
          application(service),
          http(options.http, application) {}

    const ServerOptions options;
    Log log;
    Metrics metrics;
    index::Searcher searcher;
    index::ModelReader reader;
    const StaticFiles files;
    Slots slots;
    Evaluations evaluations;
    Queries queries;
    Progress progress;
    Service service;
    IndexWatch watch;
    Application application;
    HttpServer http;
    int port = 0;
};

Server::Server(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Server::~Server() = default;

Result<void> Server::check(const ServerOptions& options) {
    auto opened = open_all(options);
    if (!opened) return opened.error();
    return {};
}

Result<std::unique_ptr<Server>> Server::open(const ServerOptions& options) {
    auto opened = open_all(options);
    if (!opened) return opened.error();
    auto& [admin_key, read_key, files, searcher] = *opened;
    searcher.store().follow_replacements();
    // Loaded now, so that the first search does not wait for it and a damaged index shows here.
    const auto snapshot = searcher.snapshot();
    if (!snapshot) return snapshot.error();

    auto parts = std::make_unique<Parts>(options, std::move(searcher), std::move(files));
    Log& log = parts->log;
    log.info(options.index.string() + ": " + std::to_string((*snapshot)->size()) +
             " models, revision " + std::to_string((*snapshot)->revision()));
    if (parts->files.size() == 0) log.warn("no gallery: its built files were not found (--web)");
    parts->service.read_key = std::move(read_key);
    if (admin_key.exists()) {
        auto store = index::Store::open(options.index, index::Access::kReadWrite);
        if (!store) return store.error();
        auto second = index::Store::open(options.index, index::Access::kReadWrite);
        if (!second) return second.error();
        Jobs::Limits limits;
        limits.waiting.waiting_bytes = options.http.max_bodies;
        limits.model_timeout_seconds = static_cast<double>(options.model_timeout.count());
        parts->service.admin_key = std::move(admin_key);
        using When = StatisticsUpdater::When;
        parts->service.statistics =
            std::make_unique<StatisticsUpdater>(*std::move(second), parts->searcher, log);
        StatisticsUpdater& statistics = *parts->service.statistics;
        statistics.request(When::kMissing);
        const auto changed = [&statistics](bool removed) {
            statistics.request(removed ? When::kOutdated : When::kMissing);
        };
        const auto describe = [reader = &parts->reader](const index::UploadedModel& upload,
                                                        const index::IndexParameters& parameters,
                                                        std::stop_token stop) {
            return index::describe_upload(upload, parameters, std::move(stop), reader);
        };
        parts->service.jobs = std::make_unique<Jobs>(*std::move(store), limits, log, parts->metrics,
                                                     changed, describe);
    }
    auto port = parts->http.bind(options.host, options.port);
    if (!port) return port.error();
    parts->port = *port;
    return std::unique_ptr<Server>(new Server(std::move(parts)));
}

int Server::port() const { return parts_->port; }

Result<void> Server::run() { return parts_->http.run(); }

void Server::stop() {
    parts_->service.draining = true;
    parts_->http.stop();
}

void Server::cancel() { parts_->http.cancel(); }

}  // namespace ossuary::server
