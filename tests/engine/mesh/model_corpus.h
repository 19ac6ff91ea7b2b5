#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::test {

/// One file of the corpora of odd and bad model files, with what its `.expect` file says of it.
struct ModelCase {
    std::string name;
    std::string bytes;
    // for files that can be read
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t triangles = 0;
    std::optional<double> area;
    std::map<std::string, std::size_t> warnings;  ///< code → count
    /// As colours_text, where the case is about colours.
    std::optional<std::string> colours;
    std::optional<double> metres_per_unit;
    std::optional<char> up;
    // for files that cannot
    std::string code;
    std::size_t line = 0;           ///< 0 where the message names none
    std::vector<std::string> says;  ///< parts of the message
};

/// How GoogleTest names and prints a case.
void PrintTo(const ModelCase& model_case, std::ostream* out);

/// The cases of tests/corpus/`format`/`folder` in the order of their names.
std::vector<ModelCase> model_cases(const std::string& format, const std::string& folder);

/// The colours of a mesh: of each triangle `rrggbb`, or `rrggbb/rrggbb/rrggbb` where its corners
/// differ; `none`.
std::string colours_text(const mesh::TriangleMesh& mesh);

/// How often each code comes.
std::map<std::string, std::size_t> counted(const std::vector<mesh::MeshWarning>& warnings);

}  // namespace ossuary::test
