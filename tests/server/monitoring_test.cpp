// What docs/monitoring/ asks of Prometheus is what /metrics has.

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "engine/core/whole_file.h"
#include "server/metrics.h"
#include "tests/support/source_folder.h"

namespace ossuary::server {
namespace {

std::string document(const std::string& name) {
    const auto file = read_whole_file(test::source_folder() / "docs/monitoring" / name);
    EXPECT_TRUE(file) << name;
    return file ? std::string(file->view()) : std::string();
}

std::set<std::string> metrics_in(const std::string& text) {
    static const std::regex kName("ossuary_[a-z_]+");
    std::set<std::string> names;
    for (std::sregex_iterator at(text.begin(), text.end(), kName), end; at != end; ++at) {
        names.insert(at->str());
    }
    return names;
}

/// All that a server has which has answered, searched and refused once.
std::set<std::string> metrics_there_are() {
    Metrics metrics;
    Exchange exchange;
    exchange.code = "overloaded";
    metrics.request(exchange);
    metrics.search({{"read", 1.0}});
    return metrics_in(metrics.text());
}

TEST(Monitoring, AsksForMetricsThatThereAre) {
    const std::set<std::string> there = metrics_there_are();
    for (const char* name : {"grafana.json", "alerts.yaml"}) {
        const std::set<std::string> asked = metrics_in(document(name));
        EXPECT_GE(asked.size(), 4u);
        for (const std::string& metric : asked) EXPECT_TRUE(there.contains(metric)) << metric;
    }
}

TEST(Monitoring, IsWellFormed) {
    const auto dashboard = nlohmann::json::parse(document("grafana.json"));
    std::set<int> ids;
    for (const auto& panel : dashboard["panels"]) {
        EXPECT_TRUE(ids.insert(panel["id"].get<int>()).second);
        EXPECT_FALSE(panel["targets"].empty());
    }
    EXPECT_GE(ids.size(), 10u);
    const YAML::Node alerts = YAML::Load(document("alerts.yaml"));
    for (const auto& rule : alerts["groups"][0]["rules"]) {
        EXPECT_TRUE(rule["alert"] && rule["expr"] && rule["annotations"]["summary"]);
    }
}

}  // namespace
}  // namespace ossuary::server
