// Real files of many programs against an independent recount, for the formats that the reader
// process reads.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "index/model_reader.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/real_formats.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

TEST(RealForeignFormats, AgreeWithAnIndependentRecount) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const fs::path folder = data / "formats";
    if (!fs::exists(folder / "truth.tsv")) GTEST_SKIP() << "formats/ not found in " << data;
    const auto truths = format_truths(folder / "truth.tsv", {"3mf", "glb", "gltf"});
    EXPECT_GE(truths.size(), 91u);
    // What is refused, and why: each reason is true of the file.
    const std::map<std::string, ErrorCode> refused = {
        // xml:space, which 3MF forbids
        {"3mf/021-MUSTFAIL_Chapter2.3.4_WhiteSpace.3mf", ErrorCode::kThreeMfInvalid},
        // two resources of one number
        {"3mf/025-MUSTFAIL_Chapter5a_DuplicatedBaseMaterials.3mf", ErrorCode::kThreeMfInvalid},
    };
    // The recount leaves out beams, which come behind the triangles.
    const std::set<std::string> with_beams = {"3mf/000-pyramid.3mf", "3mf/001-spinal implant.3mf"};
    index::ModelReader reader;
    for (const FormatTruth& truth : truths) {
        SCOPED_TRACE(truth.file);
        auto read = reader.read(folder / truth.file);
        if (with_beams.contains(truth.file)) {
            ASSERT_TRUE(read) << read.error().message;
            EXPECT_GT(read->mesh.triangles.size(), truth.triangles + 50'000);
            read->mesh.triangles.resize(truth.triangles);
            if (truth.triangles == 0) continue;
        }
        if (const auto reason = refused.find(truth.file); reason != refused.end()) {
            ASSERT_FALSE(read);
            EXPECT_EQ(read.error().code, reason->second) << read.error().message;
        } else if (!read) {
            ADD_FAILURE() << to_string(read.error().code) << ": " << read.error().message;
        } else {
            expect_agreement(read->mesh, truth, truth.area);
        }
    }
}

}  // namespace
}  // namespace ossuary::test
