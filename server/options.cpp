#include "server/options.h"

#include <CLI/CLI.hpp>

namespace ossuary::server {
namespace {

constexpr int kUsage = 2;

/// Times as the command line has them.
struct Seconds {
    long request, drain, model;
};

void add_options(CLI::App& app, ServerOptions& options, Seconds& seconds) {
    app.add_option("--index", options.index, "the index to search")->required();
    app.add_option("--host", options.host, "address to listen on")->capture_default_str();
    app.add_option("--port", options.port, "port to listen on; 0 picks a free one")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    app.add_option("--web", options.web,
                   "folder of the gallery's built files (default: web/dist above the program)");
    app.add_option("--allow-host", options.allowed_hosts,
                   "a further name that requests may call this server by, e.g. behind a proxy");
    app.add_option("--threads", options.http.threads, "connections served at once")
        ->check(CLI::Range(1, 512))
        ->capture_default_str();
    app.add_option("--searches", options.searches,
                   "searches run at once (default: the hardware threads)")
        ->check(CLI::Range(0, 1024));
    app.add_option("--max-waiting-searches", options.searches_waiting,
                   "searches that may wait; more get a 503")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str();
    app.add_option("--max-upload-bytes", options.http.max_body, "largest upload taken")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 30))
        ->capture_default_str();
    app.add_option("--kept-queries-bytes", options.kept_queries_bytes,
                   "memory for uploads that were searched with, until a quarter of an hour after "
                   "they were last asked for; 0 = none is kept")
        ->check(CLI::Range(std::size_t{0}, std::size_t{1} << 36))
        ->capture_default_str();
    app.add_flag("--serve-files", options.serve_files,
                 "let everybody who reaches the server have the indexed files themselves, and what "
                 "is made from them at full resolution");
    app.add_option("--max-evaluation-models", options.evaluation_models,
                   "larger collections are not evaluated on request")
        ->capture_default_str();
    app.add_option(
           "--request-timeout", seconds.request,
           "seconds for an upload to arrive, again for its answer to be made, and again for "
           "it to be taken")
        ->check(CLI::Range(1, 3600))
        ->capture_default_str();
    app.add_option("--model-timeout", seconds.model,
                   "seconds that an uploaded model may take to be indexed; 0 = for ever")
        ->check(CLI::Range(0, 86400))
        ->capture_default_str();
    app.add_option("--drain-timeout", seconds.drain,
                   "seconds that requests under way get to finish after SIGTERM")
        ->check(CLI::Range(0, 3600))
        ->capture_default_str();
    app.add_option("--admin-key-file", options.admin_key_file,
                   "file whose first line is the administrator's key (else OSSUARY_ADMIN_KEY)");
    app.add_option("--log-level", options.log.level, "how much to log")
        ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "critical", "off"}))
        ->capture_default_str();
    app.add_flag("--log-json", options.log.json, "log one JSON object a line");
}

}  // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
    ParsedOptions parsed;
    CLI::App app("Serves an index of 3D models: search, models and gallery over HTTP.",
                 "ossuary-server");
    app.set_version_flag("--version", "ossuary-server " OSSUARY_VERSION);
    const auto request =
        std::chrono::duration_cast<std::chrono::seconds>(parsed.options.http.request_timeout);
    Seconds seconds{request.count(), parsed.options.drain_timeout.count(),
                    parsed.options.model_timeout.count()};
    add_options(app, parsed.options, seconds);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& outcome) {
        parsed.exit_status = app.exit(outcome) == 0 ? 0 : kUsage;
        return parsed;
    }
    parsed.options.http.request_timeout = std::chrono::seconds(seconds.request);
    parsed.options.drain_timeout = std::chrono::seconds(seconds.drain);
    parsed.options.model_timeout = std::chrono::seconds(seconds.model);
    // Four uploads of the largest size at once, whatever that size is.
    parsed.options.http.max_bodies = 4 * parsed.options.http.max_body;
    parsed.run = true;
    return parsed;
}

std::filesystem::path find_web_folder(const std::filesystem::path& program) {
    namespace fs = std::filesystem;
    std::error_code fault;
    for (fs::path folder = program.parent_path(); folder.has_relative_path();
         folder = folder.parent_path()) {
        if (fs::is_regular_file(folder / "web/dist/index.html", fault)) return folder / "web/dist";
    }
    const fs::path installed = "/usr/share/ossuary/web";
    return fs::is_regular_file(installed / "index.html", fault) ? installed : fs::path();
}

}  // namespace ossuary::server
