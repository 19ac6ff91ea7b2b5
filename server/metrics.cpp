#include "server/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

#include <array>
#include <chrono>
#include <string_view>

namespace ossuary::server {
namespace {

template <typename T>
using Family = prometheus::Family<T>;

const prometheus::Histogram::BucketBoundaries kSeconds = {.001, .0025, .005, .01, .025, .05, .1,
                                                          .25,  .5,    1,    2.5, 5,    10,  30};

Family<prometheus::Counter>& counter(prometheus::Registry& registry, const char* name,
                                     const char* help) {
    return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}
Family<prometheus::Gauge>& gauge(prometheus::Registry& registry, const char* name,
                                 const char* help) {
    return prometheus::BuildGauge().Name(name).Help(help).Register(registry);
}
Family<prometheus::Histogram>& histogram(prometheus::Registry& registry, const char* name,
                                         const char* help) {
    return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

/// Anyone can invent methods; a label for each would be a leak.
std::string method_label(std::string_view method) {
    constexpr std::array<std::string_view, 7> kKnown = {"GET",   "HEAD",   "POST",   "PUT",
                                                        "PATCH", "DELETE", "OPTIONS"};
    for (const std::string_view known : kKnown) {
        if (known == method) return std::string(known);
    }
    return "other";
}

}  // namespace

struct Metrics::Impl {
    prometheus::Registry registry;
    Family<prometheus::Counter>& requests =
        counter(registry, "ossuary_http_requests_total", "Requests answered.");
    Family<prometheus::Histogram>& durations =
        histogram(registry, "ossuary_http_request_duration_seconds",
                  "From the first byte of a request to the last of its answer.");
    Family<prometheus::Counter>& problems =
        counter(registry, "ossuary_http_problems_total", "Problem documents sent, by code.");
    prometheus::Counter& bytes_in =
        counter(registry, "ossuary_http_received_bytes_total", "Bytes of requests.").Add({});
    prometheus::Counter& bytes_out =
        counter(registry, "ossuary_http_sent_bytes_total", "Bytes of answers.").Add({});
    prometheus::Counter& refused = counter(registry, "ossuary_http_connections_refused_total",
                                           "Connections turned away because too many were waiting.")
                                       .Add({});
    Family<prometheus::Histogram>& stages =
        histogram(registry, "ossuary_search_stage_duration_seconds",
                  "Time in each stage of searches by upload.");
    prometheus::Gauge& searches_waiting =
        gauge(registry, "ossuary_searches_waiting", "Searches that wait for a slot.").Add({});
    prometheus::Gauge& models =
        gauge(registry, "ossuary_index_models", "Models in the index.").Add({});
    prometheus::Gauge& revision =
        gauge(registry, "ossuary_index_revision", "Revision of the index.").Add({});
    prometheus::Gauge& jobs_waiting =
        gauge(registry, "ossuary_jobs_waiting", "Uploaded models that wait to be indexed.").Add({});
    Family<prometheus::Counter>& jobs_done =
        counter(registry, "ossuary_jobs_total", "Uploaded models that were indexed, by outcome.");
    prometheus::Gauge& started =
        gauge(registry, "ossuary_start_time_seconds", "When the server started, Unix time.")
            .Add({});

    Impl() {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        started.Set(std::chrono::duration<double>(now).count());
        jobs_done.Add({{"outcome", "done"}});
        jobs_done.Add({{"outcome", "failed"}});
    }
};

Metrics::Metrics() : impl_(std::make_unique<Impl>()) {}

Metrics::~Metrics() = default;

void Metrics::request(const Exchange& exchange) {
    const std::string route = exchange.route.empty() ? "none" : exchange.route;
    impl_->requests
        .Add({{"route", route},
              {"method", method_label(exchange.method)},
              {"status", std::to_string(exchange.status)}})
        .Increment();
    impl_->durations.Add({{"route", route}}, kSeconds).Observe(exchange.milliseconds / 1000.0);
    if (!exchange.code.empty()) impl_->problems.Add({{"code", exchange.code}}).Increment();
    impl_->bytes_in.Increment(static_cast<double>(exchange.bytes_in));
    impl_->bytes_out.Increment(static_cast<double>(exchange.bytes_out));
}

void Metrics::connection_refused() { impl_->refused.Increment(); }

void Metrics::search(const StageTimes& stages) {
    for (const StageTime& stage : stages) {
        impl_->stages.Add({{"stage", stage.stage}}, kSeconds).Observe(stage.milliseconds / 1000.0);
    }
}

void Metrics::jobs(std::size_t waiting) { impl_->jobs_waiting.Set(static_cast<double>(waiting)); }

void Metrics::job_done(bool succeeded) {
    impl_->jobs_done.Add({{"outcome", succeeded ? "done" : "failed"}}).Increment();
}

void Metrics::index(std::size_t models, std::int64_t revision) {
    impl_->models.Set(static_cast<double>(models));
    impl_->revision.Set(static_cast<double>(revision));
}

void Metrics::searches_waiting(std::size_t count) {
    impl_->searches_waiting.Set(static_cast<double>(count));
}

std::string Metrics::text() const {
    return prometheus::TextSerializer().Serialize(impl_->registry.Collect());
}

}  // namespace ossuary::server
