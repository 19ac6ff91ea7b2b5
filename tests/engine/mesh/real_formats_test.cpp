// Real files of many programs against an independent recount of their triangles, area and bounds.

#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "engine/mesh/read_mesh.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/real_formats.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

TEST(RealFormats, AgreeWithAnIndependentRecount) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const fs::path folder = data / "formats";
    if (!fs::exists(folder / "truth.tsv")) GTEST_SKIP() << "formats/ not found in " << data;
    // What is refused, and why: each reason is true of the file.
    const std::map<std::string, ErrorCode> refused = {
        {"obj/130-empty.obj", ErrorCode::kFormatUnknown},      // one comment
        {"obj/131-obj_empty.obj", ErrorCode::kFormatUnknown},  // two comments
    };
    // The recount cuts polygons as fans, which overlap where the polygon is concave: these are the
    // areas of the polygons themselves (Newell's formula). One is not flat and has no area of its
    // own.
    const std::map<std::string, std::optional<double>> areas = {
        {"obj/095-concave_polygon.obj", 0.24549668720},
        {"obj/100-space_in_material_name.obj", 0.24549668720},
        {"obj/140-polygonfaces.obj", std::nullopt},
        {"obj/148-wallhole.obj", 721.42135623731},
    };
    const auto truths = format_truths(folder / "truth.tsv", {"off", "stl", "obj", "ply"});
    EXPECT_GE(truths.size(), 98u);
    for (const FormatTruth& truth : truths) {
        SCOPED_TRACE(truth.file);
        const auto read = mesh::read_mesh(folder / truth.file);
        if (const auto reason = refused.find(truth.file); reason != refused.end()) {
            ASSERT_FALSE(read);
            EXPECT_EQ(read.error().code, reason->second) << read.error().message;
            continue;
        }
        if (!read) {
            ADD_FAILURE() << read.error().message;
            continue;
        }
        const auto known = areas.find(truth.file);
        expect_agreement(read->mesh, truth, known == areas.end() ? truth.area : known->second);
    }
}

}  // namespace
}  // namespace ossuary::test
