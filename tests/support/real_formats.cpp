#include "tests/support/real_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "engine/mesh/measures.h"

namespace ossuary::test {
namespace {

/// Of all corners, also those of triangles without area.
Box3 bounds_of(const mesh::TriangleMesh& mesh) {
    Box3 bounds;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) bounds.extend(mesh.vertices[vertex]);
    }
    return bounds;
}

}  // namespace

std::vector<FormatTruth> format_truths(const std::filesystem::path& table,
                                       const std::vector<std::string>& folders) {
    std::vector<FormatTruth> truths;
    std::ifstream file(table);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream columns(line);
        FormatTruth truth;
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

void expect_agreement(const mesh::TriangleMesh& mesh, const FormatTruth& truth,
                      const std::optional<double>& area) {
    EXPECT_EQ(mesh.triangles.size(), truth.triangles);
    if (area) {
        EXPECT_NEAR(mesh::measure(mesh).surface_area, *area, 1e-4 * *area);
    }
    if (truth.bounds.isEmpty()) return;
    const Box3 bounds = bounds_of(mesh);
    const double tolerance = 1e-4 * truth.bounds.diagonal().norm();
    EXPECT_LE((bounds.min() - truth.bounds.min()).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_LE((bounds.max() - truth.bounds.max()).cwiseAbs().maxCoeff(), tolerance);
}

}  // namespace ossuary::test
