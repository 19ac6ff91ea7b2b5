#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "server/http.h"
#include "server/log.h"

namespace ossuary::server {

/// What the command line says.
struct ServerOptions {
    std::filesystem::path index;
    bool create = false;        ///< an empty index where there is none
    bool check_config = false;  ///< say what would be done, and do not serve
    std::string host = "127.0.0.1";
    int port = 8080;
    std::filesystem::path web;               ///< empty: looked for beside the program
    std::vector<std::string> allowed_hosts;  ///< besides the loopback names
    std::filesystem::path admin_key_file, read_key_file;
    std::vector<std::string> allowed_origins;  ///< whose pages may read answers; `*` for all
    HttpOptions http;
    std::size_t searches = 0;                    ///< at once; 0 = one for each hardware thread
    std::size_t searches_waiting = 32;           ///< more are turned away
    std::size_t kept_queries_bytes = 256 << 20;  ///< of memory for uploads that were searched with
    bool serve_files = false;                    ///< whether the files themselves may be had
    std::size_t evaluation_models = 1500;     ///< of larger collections a sample is searched with
    std::vector<std::string> embedders;       ///< origins whose pages may show a model in a frame
    std::chrono::seconds model_timeout{600};  ///< to describe an uploaded model; 0 = for ever
    std::chrono::seconds drain_timeout{30};
    LogOptions log;
    std::string effective;  ///< all options with their values, in the form of a configuration file
};

/// What `parse_options` found: options to run with, or an exit status after having printed why.
struct ParsedOptions {
    ServerOptions options;
    bool run = false;
    int exit_status = 0;
};

/// Options come from a file (`--config`), from the environment, where `--max-upload-bytes` is
/// OSSUARY_MAX_UPLOAD_BYTES, and from the command line; the later win.
ParsedOptions parse_options(int argc, const char* const* argv);

/// Where the gallery's built files are when the command line does not say: `web/dist` in a folder
/// above the program's, else /usr/share/ossuary/web; empty where there are none.
[[nodiscard]] std::filesystem::path find_web_folder(const std::filesystem::path& program);

}  // namespace ossuary::server
