#include "index/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <regex>

#include "index/report_text.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

Evaluation sample_evaluation(ranking::RankerKind ranker, std::uint64_t seed) {
    Evaluation evaluation;
    evaluation.ranker = ranker;
    evaluation.rerank = seed == 2;
    evaluation.report = test::sample_report(seed);
    evaluation.computed_at = "2026-01-01T00:00:00Z";
    return evaluation;
}

std::vector<Evaluation> two() {
    return {sample_evaluation(ranking::RankerKind::kHybrid, 1),
            sample_evaluation(ranking::RankerKind::kSkeleton, 2)};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

/// Every tag is closed, in order; enough of XML for what is written here.
bool is_balanced(const std::string& markup) {
    static const std::vector<std::string> kVoid = {"meta", "br"};
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-zA-Z0-9]+)([^<>]*?)(/?)>");
    for (auto at = std::sregex_iterator(markup.begin(), markup.end(), tag);
         at != std::sregex_iterator(); ++at) {
        const std::string name = (*at)[2];
        if ((*at)[4].length() > 0 || std::find(kVoid.begin(), kVoid.end(), name) != kVoid.end()) {
            continue;
        }
        if ((*at)[1].length() == 0) {
            open.push_back(name);
        } else if (open.empty() || open.back() != name) {
            return false;
        } else {
            open.pop_back();
        }
    }
    return open.empty();
}

TEST(Report, PlotsOneCurveForEachEvaluation) {
    const std::string svg = precision_recall_svg(two());
    EXPECT_TRUE(svg.starts_with("<svg xmlns="));
    EXPECT_TRUE(is_balanced(svg));
    EXPECT_EQ(count(svg, "<polyline"), 2U);
    EXPECT_NE(svg.find("skeleton, re-ranked"), std::string::npos);
    const std::regex points("points=\"([^\"]*)\"");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(svg, found, points));
    EXPECT_EQ(count(found[1], ","), 20U);
}

TEST(Report, PlotsWithinItsFrame) {
    Evaluation evaluation = sample_evaluation(ranking::RankerKind::kHybrid, 1);
    evaluation.report.precision_recall = {{0.0, 0.0}, {1.0, 1.0}};
    const std::string svg = precision_recall_svg({&evaluation, 1});
    EXPECT_NE(svg.find("points=\"64.0,424.0 696.0,24.0\""), std::string::npos);
    EXPECT_TRUE(is_balanced(precision_recall_svg({}))) << "also when there is nothing";
}

TEST(Report, WritesNumbersThatReadBackTheSame) {
    const auto evaluations = two();
    const std::string csv = precision_recall_csv(evaluations);
    EXPECT_EQ(count(csv, "\n"), 1U + 40U);
    const std::string wanted = "hybrid,false,0.05,";
    const std::size_t at = csv.find(wanted);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(std::stod(csv.substr(at + wanted.size())),
              evaluations[0].report.precision_recall[0].precision);
}

TEST(Report, ListsMetricsOverallAndByClass) {
    const std::string csv = metrics_csv(two());
    EXPECT_EQ(count(csv, "\n"), 1U + 2U * 3U);
    EXPECT_NE(csv.find("hybrid,false,,7,"), std::string::npos);
    EXPECT_NE(csv.find("skeleton,true,\"a, \"\"b\"\" <c>\",4,"), std::string::npos);
}

TEST(Report, ComparesRankersOfTheSameQueries) {
    std::vector<Evaluation> evaluations = two();
    evaluations[1].report.per_query = evaluations[0].report.per_query;
    for (ranking::QueryMetrics& query : evaluations[1].report.per_query) query.metrics.dcg += 0.25;
    const std::string csv = comparisons_csv(evaluations);
    EXPECT_EQ(count(csv, "\n"), 1U + 6U);
    const std::size_t at = csv.find(",dcg,");
    ASSERT_NE(at, std::string::npos);
    EXPECT_NEAR(std::stod(csv.substr(at + 5)), 0.25, 1e-12);
    EXPECT_NE(report_html(evaluations).find("Rankers against each other"), std::string::npos);

    evaluations[1].report.per_query.pop_back();
    EXPECT_EQ(count(comparisons_csv(evaluations), "\n"), 1U) << "other queries";
}

TEST(Report, IsOnePageThatNeedsNothingElse) {
    const std::string html = report_html(two());
    EXPECT_TRUE(is_balanced(html.substr(html.find("<html"))));
    EXPECT_EQ(html.find("src="), std::string::npos);
    EXPECT_EQ(html.find("href="), std::string::npos);
    EXPECT_EQ(html.find("<c>"), std::string::npos) << "class names are text, not markup";
    EXPECT_NE(html.find("&lt;c&gt;"), std::string::npos);
    EXPECT_EQ(count(html, "class=\"confusion\""), 2U);
    EXPECT_NE(html.find(">75</td>"), std::string::npos) << "a share in percent";
}

TEST(Report, WritesItsFiles) {
    const test::TemporaryFolder folder;
    const auto target = folder.path() / "new" / "report";
    ASSERT_TRUE(write_report(target, two()));
    EXPECT_EQ(test::read_file(target / "report.html"), report_html(two()));
    EXPECT_EQ(test::read_file(target / "metrics.csv"), metrics_csv(two()));
    EXPECT_EQ(test::read_file(target / "precision-recall.csv"), precision_recall_csv(two()));
    EXPECT_EQ(test::read_file(target / "precision-recall.svg"), precision_recall_svg(two()));

    test::write_file(folder.path() / "file", "x");
    const auto refused = write_report(folder.path() / "file" / "report", two());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kFileUnwritable);
}

TEST(Report, WritesDistancesAsLittleEndianFloats) {
    const test::TemporaryFolder folder;
    ranking::DistanceMatrix matrix{2, {0.0F, 1.0F, -2.5F, 0.0F}};
    ASSERT_TRUE(write_matrix(folder.path() / "m.bin", matrix));
    const std::string bytes = test::read_file(folder.path() / "m.bin");
    EXPECT_EQ(bytes, std::string("\0\0\0\0\0\0\x80\x3F\0\0\x20\xC0\0\0\0\0", 16));
    EXPECT_EQ(write_matrix(folder.path() / "none" / "m.bin", matrix).error().code,
              ErrorCode::kFileUnwritable);
}

TEST(ReportText, EscapesWhatWouldBeMarkup) {
    EXPECT_EQ(markup_text("<a b=\"c\">&"), "&lt;a b=&quot;c&quot;&gt;&amp;");
    EXPECT_EQ(csv_field("plain"), "plain");
    EXPECT_EQ(csv_field("a\"b,c\n"), "\"a\"\"b,c\n\"");
    EXPECT_EQ(markup_text("b\xE4r\x1B\xEF\xBF\xBF"), "b\xEF\xBF\xBDr\xEF\xBF\xBD\xEF\xBF\xBD");
    EXPECT_EQ(csv_field("b\xE4r"), "b\xEF\xBF\xBDr");
    EXPECT_EQ(fixed(0.12345, 3), "0.123");
    EXPECT_EQ(fixed(1e300, 1).size(), 303U);
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(std::nan("")), "");
}

}  // namespace
}  // namespace ossuary::index
