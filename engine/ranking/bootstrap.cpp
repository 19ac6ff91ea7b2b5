#include "engine/ranking/bootstrap.h"

#include <algorithm>
#include <cassert>
#include <random>
#include <vector>

namespace ossuary::ranking {
namespace {

constexpr std::size_t kResamples = 2000;
constexpr std::uint64_t kSeed = 0x05507A27;

/// The same on every platform, unlike std::uniform_int_distribution.
std::size_t below(std::mt19937_64& random, std::size_t count) {
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
    return static_cast<std::size_t>(unit * static_cast<double>(count));
}

}  // namespace

BootstrapMean bootstrap_mean(std::span<const double> values) {
    if (values.empty()) return {};
    const auto count = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values) sum += value;
    std::mt19937_64 random(kSeed);
    std::vector<double> means;
    for (std::size_t resample = 0; resample < kResamples; ++resample) {
        double resampled = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            resampled += values[below(random, values.size())];
        }
        means.push_back(resampled / count);
    }
    std::sort(means.begin(), means.end());
    return {sum / count, means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

BootstrapMean bootstrap_measure(const RetrievalReport& report, double RetrievalMetrics::*measure) {
    std::vector<double> values;
    for (const QueryMetrics& query : report.per_query) values.push_back(query.metrics.*measure);
    return bootstrap_mean(values);
}

BootstrapMean bootstrap_difference(const RetrievalReport& first, const RetrievalReport& second,
                                   double RetrievalMetrics::*measure) {
    assert(first.per_query.size() == second.per_query.size());
    std::vector<double> values;
    for (std::size_t i = 0; i < first.per_query.size(); ++i) {
        assert(first.per_query[i].model == second.per_query[i].model);
        values.push_back(second.per_query[i].metrics.*measure -
                         first.per_query[i].metrics.*measure);
    }
    return bootstrap_mean(values);
}

}  // namespace ossuary::ranking
