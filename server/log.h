#pragma once

#include <spdlog/logger.h>
#include <memory>
#include <string>

#include "server/http.h"

namespace ossuary::server {

struct LogOptions {
    std::string level = "info";  ///< trace, debug, info, warn, error, critical, off
    bool json = false;           ///< one JSON object a line
};

/// The server's log, on stderr.
class Log {
public:
    explicit Log(const LogOptions& options = {});

    void debug(const std::string& message) { write(spdlog::level::debug, message); }
    void info(const std::string& message) { write(spdlog::level::info, message); }
    void warn(const std::string& message) { write(spdlog::level::warn, message); }
    void error(const std::string& message) { write(spdlog::level::err, message); }
    /// What went wrong on our side in one request.
    void error(const std::string& message, const std::string& request_id);
    /// One line for each request.
    void access(const Exchange& exchange);

private:
    void write(spdlog::level::level_enum level, const std::string& message);

    std::shared_ptr<spdlog::logger> logger_;
    bool json_ = false;
};

}  // namespace ossuary::server
