#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/core/stopwatch.h"
#include "server/http.h"

namespace ossuary::server {

/// Counts and times what the server does, for Prometheus. docs/operations.md lists the names.
class Metrics {
public:
    Metrics();
    ~Metrics();
    Metrics(const Metrics&) = delete;
    Metrics& operator=(const Metrics&) = delete;

    void request(const Exchange& exchange);
    void connection_refused();
    void search(const StageTimes& stages);
    void jobs(std::size_t waiting);
    void job_done(bool succeeded);
    void index(std::size_t models, std::int64_t revision);
    void searches_waiting(std::size_t count);

    /// In the Prometheus text format, version 0.0.4.
    [[nodiscard]] std::string text() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ossuary::server
