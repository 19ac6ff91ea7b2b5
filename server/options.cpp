#include "server/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ossuary::server {
namespace {

constexpr int kUsage = 2;

/// Times as the command line has them.
struct Seconds {
    long request, drain, model;
};

/// An origin as browsers name it, or `*` for all: a scheme, a host and perhaps a port.
std::string is_origin(const std::string& origin) {
    const auto rest = [&]() -> std::string_view {
        for (const std::string_view scheme : {"https://", "http://"}) {
            if (origin.starts_with(scheme)) return std::string_view(origin).substr(scheme.size());
        }
        return {};
    }();
    const bool sound = !rest.empty() && std::all_of(rest.begin(), rest.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == ':';
    });
    return origin == "*" || sound ? "" : origin + ": expected https://HOST[:PORT], or *";
}

/// Segments of unreserved characters, which no address has to escape.
std::string is_base_path(const std::string& path) {
    const bool sound =
        path.size() > 1 && path.front() == '/' && path.back() != '/' &&
        path.find("//") == std::string::npos && path.find("/.") == std::string::npos &&
        std::all_of(path.begin(), path.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   std::string_view("-._~/").find(c) != std::string_view::npos;
        });
    return sound ? "" : path + ": expected a path like /models, without a slash at its end";
}

/// Who may do what, and by which addresses.
void add_access_options(CLI::App& app, ServerOptions& options) {
    app.add_option("--allow-host", options.allowed_hosts,
                   "a further name that requests may call this server by, e.g. behind a proxy; "
                   "several with commas between")
        ->delimiter(',')
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--allow-embedding", options.embedders,
                   "an origin (https://example.com) whose pages may show models in a frame, see "
                   "/embed.html; * for all")
        ->delimiter(',')
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(is_origin);
    app.add_option("--allow-origin", options.allowed_origins,
                   "an origin (https://example.com) whose pages may read answers and send "
                   "searches (CORS); * for all; several with commas between")
        ->delimiter(',')
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(is_origin);
    app.add_option("--base-path", options.http.base_path,
                   "what stands before every path, for a proxy that leads a part of a site here: "
                   "/models")
        ->check(is_base_path);
    app.add_flag("--serve-files", options.serve_files,
                 "let everybody who reaches the server have the indexed files themselves, and what "
                 "is made from them at full resolution");
    app.add_option("--admin-key-file", options.admin_key_file,
                   "file whose first line is the administrator's key (else OSSUARY_ADMIN_KEY); "
                   "another one holds once it is there");
    app.add_option("--read-key-file", options.read_key_file,
                   "file whose first line is the key that readers need (else OSSUARY_READ_KEY; "
                   "neither: everybody who reaches the server may read)");
}

void add_options(CLI::App& app, ServerOptions& options, Seconds& seconds) {
    app.set_config("--config", "", "a file of options, one a line: port = 8080");
    app.allow_config_extras(CLI::config_extras_mode::error);
    app.add_option("--index", options.index, "the index to search")->required();
    app.add_flag("--create", options.create, "make an empty index where there is none");
    app.add_flag("--check-config", options.check_config,
                 "say whether index, gallery and key can be used, and with which options; serve "
                 "nothing")
        ->configurable(false);
    app.add_option("--host", options.host, "address to listen on")->capture_default_str();
    app.add_option("--port", options.port, "port to listen on; 0 picks a free one")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    app.add_option("--web", options.web,
                   "folder of the gallery's built files (default: web/dist above the program)");
    add_access_options(app, options);
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
    app.add_option("--max-evaluation-models", options.evaluation_models,
                   "of larger collections reports are made by searching with a sample")
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
    app.add_option("--log-level", options.log.level, "how much to log")
        ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "critical", "off"}))
        ->capture_default_str();
    app.add_flag("--log-json", options.log.json, "log one JSON object a line");
}

/// OSSUARY_MAX_UPLOAD_BYTES for `max-upload-bytes`.
std::string variable_of(std::string_view option) {
    std::string name = "OSSUARY_";
    for (const char c : option) name += c == '-' ? '_' : static_cast<char>(c - 'a' + 'A');
    return name;
}

/// What the environment says, as words of the command line.
std::vector<std::string> environment_arguments(const CLI::App& app) {
    std::vector<std::string> arguments;
    for (const CLI::Option* option : app.get_options()) {
        const bool is_setting = option->get_configurable() || option == app.get_config_ptr();
        if (!is_setting || option->get_lnames().empty()) continue;
        const std::string& name = option->get_lnames().front();
        const char* value = std::getenv(variable_of(name).c_str());
        if (value != nullptr && *value != '\0') arguments.push_back("--" + name + "=" + value);
    }
    return arguments;
}

/// Those of the environment come first, so that those of the command line win.
void parse(CLI::App& app, const std::vector<std::string>& environment, int argc,
           const char* const* argv) {
    std::vector<std::string> arguments = environment;
    arguments.insert(arguments.end(), argv + std::min(argc, 1), argv + argc);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    app.parse(std::move(arguments));
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
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.footer(
        "Each option may stand in the file of --config, and in the environment: --port as "
        "OSSUARY_PORT. The command line wins over the environment, that over the file.");
    add_options(app, parsed.options, seconds);
    const std::vector<std::string> environment = environment_arguments(app);
    try {
        parse(app, environment, argc, argv);
    } catch (const CLI::ParseError& outcome) {
        parsed.exit_status = app.exit(outcome) == 0 ? 0 : kUsage;
        if (outcome.get_exit_code() == static_cast<int>(CLI::ExitCodes::ConfigError)) {
            std::cerr << "The file of --config has an option that there is not.\n";
        }
        if (parsed.exit_status != 0 && !environment.empty()) {
            std::cerr << "From the environment:";
            for (const std::string& argument : environment) std::cerr << ' ' << argument;
            std::cerr << '\n';
        }
        return parsed;
    }
    parsed.options.http.request_timeout = std::chrono::seconds(seconds.request);
    parsed.options.drain_timeout = std::chrono::seconds(seconds.drain);
    parsed.options.model_timeout = std::chrono::seconds(seconds.model);
    // Four uploads of the largest size at once, whatever that size is.
    parsed.options.http.max_bodies = 4 * parsed.options.http.max_body;
    parsed.options.effective = app.config_to_str(true);
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
