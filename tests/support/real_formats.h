#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/mesh/triangle_mesh.h"

namespace ossuary::test {

/// What an independent recount found in a file of another project's collection (truth.tsv).
struct FormatTruth {
    std::string file;  ///< below the table's folder
    std::size_t triangles = 0;
    double area = 0;
    Box3 bounds;  ///< empty where there is no triangle
};

/// The rows of truth.tsv for files in one of the folders.
std::vector<FormatTruth> format_truths(const std::filesystem::path& table,
                                       const std::vector<std::string>& folders);

/// Holds a mesh against them: the number of triangles, the area within 1e-4 (none = it is not asked
/// for), the bounds within 1e-4 of the diagonal.
void expect_agreement(const mesh::TriangleMesh& mesh, const FormatTruth& truth,
                      const std::optional<double>& area);

}  // namespace ossuary::test
