// Real files of many programs against an independent recount of their triangles, area and bounds.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

struct Truth {
    std::string file;
    std::size_t triangles = 0;
    double area = 0;
    Box3 bounds;  ///< empty where there is no triangle
};

/// The rows of truth.tsv for files in one of the folders.
std::vector<Truth> truths_of(const fs::path& table, const std::vector<std::string>& folders) {
    std::vector<Truth> truths;
    std::ifstream file(table);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream columns(line);
        Truth truth;
        std::getline(columns, truth.file, '\t');
        const std::string folder = truth.file.substr(0, truth.file.find('/'));
        if (std::find(folders.begin(), folders.end(), folder) == folders.end()) continue;
        columns >> truth.triangles >> truth.area;
        Vec3 low, high;
        std::string dots;
        if (columns >> low[0] >> low[1] >> low[2] >> dots >> high[0] >> high[1] >> high[2]) {
            truth.bounds = Box3(low, high);
        }
        truths.push_back(truth);
    }
    return truths;
}

/// Of all corners, also those of triangles without area.
Box3 bounds_of(const mesh::TriangleMesh& mesh) {
    Box3 bounds;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) bounds.extend(mesh.vertices[vertex]);
    }
    return bounds;
}

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
    const auto truths = truths_of(folder / "truth.tsv", {"off", "stl", "obj", "ply"});
    EXPECT_GE(truths.size(), 98u);
    for (const Truth& truth : truths) {
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
        EXPECT_EQ(read->mesh.triangles.size(), truth.triangles);
        const auto known = areas.find(truth.file);
        const std::optional<double> area = known == areas.end() ? truth.area : known->second;
        if (area) {
            EXPECT_NEAR(mesh::measure(read->mesh).surface_area, *area, 1e-4 * *area);
        }
        if (truth.bounds.isEmpty()) continue;
        const Box3 bounds = bounds_of(read->mesh);
        const double tolerance = 1e-4 * truth.bounds.diagonal().norm();
        EXPECT_LE((bounds.min() - truth.bounds.min()).cwiseAbs().maxCoeff(), tolerance);
        EXPECT_LE((bounds.max() - truth.bounds.max()).cwiseAbs().maxCoeff(), tolerance);
    }
}

}  // namespace
}  // namespace ossuary::test
