#include "server/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "index/json_text.h"

namespace ossuary::server {
namespace {

using Json = nlohmann::ordered_json;
using index::json_text;

}  // namespace

Log::Log(const LogOptions& options) : json_(options.json) {
    spdlog::sink_ptr sink;
    if (options.json || std::getenv("NO_COLOR") != nullptr) {
        sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
    } else {
        sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
    }
    // Not registered by name: there is no log but the one that is handed on.
    logger_ = std::make_shared<spdlog::logger>("ossuary-server", std::move(sink));
    logger_->set_level(spdlog::level::from_str(options.level));
    logger_->flush_on(spdlog::level::info);
    if (options.json) {
        logger_->set_pattern("{\"time\":\"%Y-%m-%dT%H:%M:%S.%eZ\",\"level\":\"%l\",%v}",
                             spdlog::pattern_time_type::utc);
    } else {
        logger_->set_pattern("%Y-%m-%dT%H:%M:%S.%eZ %^%-5l%$ %v", spdlog::pattern_time_type::utc);
    }
}

void Log::write(spdlog::level::level_enum level, const std::string& message) {
    if (!logger_->should_log(level)) return;
    logger_->log(level, "{}",
                 json_ ? "\"message\":" + json_text(Json(message)) : terminal_text(message));
}

void Log::error(const std::string& message, const std::string& request_id) {
    if (json_) {
        logger_->error("\"message\":{},\"request_id\":{}", json_text(Json(message)),
                       json_text(Json(request_id)));
    } else {
        logger_->error("{} [{}]", terminal_text(message), request_id);
    }
}

void Log::access(const Exchange& exchange) {
    if (!logger_->should_log(spdlog::level::info)) return;
    if (!json_) {
        logger_->info("{} {} {} {}{}{} {:.1f} ms in {} out {} [{}]", exchange.remote_address,
                      exchange.method.empty() ? "-" : exchange.method,
                      terminal_text(exchange.target), exchange.status,
                      exchange.code.empty() ? "" : " ", exchange.code, exchange.milliseconds,
                      exchange.bytes_in, exchange.bytes_out, exchange.id);
        return;
    }
    const std::string object = json_text(Json{{"message", "request"},
                                              {"request_id", exchange.id},
                                              {"remote", exchange.remote_address},
                                              {"method", exchange.method},
                                              {"target", exchange.target},
                                              {"route", exchange.route},
                                              {"status", exchange.status},
                                              {"code", exchange.code},
                                              {"milliseconds", exchange.milliseconds},
                                              {"bytes_in", exchange.bytes_in},
                                              {"bytes_out", exchange.bytes_out}});
    logger_->info("{}", std::string_view(object).substr(1, object.size() - 2));
}

}  // namespace ossuary::server
