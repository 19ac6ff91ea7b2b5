#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/mesh/read_mesh.h"

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

/// A case and the folder of tests/corpus/ that it lies in, which its format names.
struct FormatCase {
    std::string format;
    ModelCase model;
};

/// How GoogleTest names and prints a case.
std::string case_name(const testing::TestParamInfo<FormatCase>& info);
void PrintTo(const FormatCase& format_case, std::ostream* out);

/// The cases of tests/corpus/`format`/`folder` in the order of their names.
std::vector<ModelCase> model_cases(const std::string& format, const std::string& folder);

/// Those of each format.
std::vector<FormatCase> format_cases(const std::vector<std::string>& formats,
                                     const std::string& folder);

/// The colours of a mesh: of each triangle `rrggbb`, or `rrggbb/rrggbb/rrggbb` where its corners
/// differ; `none`.
std::string colours_text(const mesh::TriangleMesh& mesh);

/// How often each code comes.
std::map<std::string, std::size_t> counted(const std::vector<mesh::MeshWarning>& warnings);

/// That a model was read and has the sizes, the warnings and the area that its case says.
void expect_read(const Result<mesh::ReadMeshResult>& read, const ModelCase& expected);

/// That a model of the name `name` was refused with the code that its case says and a message that
/// begins with the name, says what was expected and all that its case says.
void expect_refused(const Result<mesh::ReadMeshResult>& read, const ModelCase& expected,
                    const std::string& name);

/// That a message of one of our own readers is ASCII and names the line that its case says.
void expect_line(const std::string& message, const ModelCase& expected);

/// That each triangle has a face and vertices of the mesh, which are all finite.
void expect_whole(const mesh::TriangleMesh& mesh);

}  // namespace ossuary::test
