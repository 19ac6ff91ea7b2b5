#include "tests/engine/mesh/model_corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/mesh/measures.h"
#include "tests/support/source_folder.h"

namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("missing corpus file " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

ModelCase read_case(const fs::path& path) {
    ModelCase model_case;
    model_case.name = path.stem().string();
    model_case.bytes = contents(path);
    std::istringstream lines(contents(fs::path(path).replace_extension(".expect")));
    for (std::string key; lines >> key;) {
        if (key == "vertices") {
            lines >> model_case.vertices;
        } else if (key == "faces") {
            lines >> model_case.faces;
        } else if (key == "triangles") {
            lines >> model_case.triangles;
        } else if (key == "area") {
            lines >> model_case.area.emplace();
        } else if (key == "warning") {
            std::string code;
            lines >> code >> model_case.warnings[code];
        } else if (key == "colours") {
            std::getline(lines >> std::ws, model_case.colours.emplace());
        } else if (key == "unit") {
            lines >> model_case.metres_per_unit.emplace();
        } else if (key == "up") {
            lines >> model_case.up.emplace();
        } else if (key == "code") {
            lines >> model_case.code;
        } else if (key == "line") {
            lines >> model_case.line;
        } else if (key == "says") {
            std::getline(lines >> std::ws, model_case.says.emplace_back());
        } else {
            throw std::runtime_error(path.string() + ": unknown expectation " + key);
        }
    }
    return model_case;
}

}  // namespace

std::string case_name(const testing::TestParamInfo<FormatCase>& info) {
    return info.param.format + "_" + info.param.model.name;
}

void PrintTo(const FormatCase& format_case, std::ostream* out) {
    *out << format_case.format << "/" << format_case.model.name;
}

std::vector<ModelCase> model_cases(const std::string& format, const std::string& folder) {
    std::vector<ModelCase> cases;
    const fs::path root = source_folder() / "tests" / "corpus" / format / folder;
    for (const auto& entry : fs::directory_iterator(root)) {
        if (entry.path().extension() == "." + format) cases.push_back(read_case(entry.path()));
    }
    std::sort(cases.begin(), cases.end(),
              [](const ModelCase& a, const ModelCase& b) { return a.name < b.name; });
    return cases;
}

std::vector<FormatCase> format_cases(const std::vector<std::string>& formats,
                                     const std::string& folder) {
    std::vector<FormatCase> cases;
    for (const std::string& format : formats) {
        for (ModelCase& model : model_cases(format, folder)) {
            cases.push_back({format, std::move(model)});
        }
    }
    return cases;
}

std::string colours_text(const mesh::TriangleMesh& mesh) {
    std::string text;
    const auto put = [&](const mesh::Colour& colour) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        for (const std::uint8_t channel : colour) {
            text += kDigits[channel / 16];
            text += kDigits[channel % 16];
        }
    };
    for (const auto& [a, b, c] : mesh.corner_colours) {
        if (!text.empty()) text += ' ';
        put(a);
        if (a == b && b == c) continue;
        for (const mesh::Colour& other : {b, c}) {
            text += '/';
            put(other);
        }
    }
    return text.empty() ? "none" : text;
}

std::map<std::string, std::size_t> counted(const std::vector<mesh::MeshWarning>& warnings) {
    std::map<std::string, std::size_t> counts;
    for (const mesh::MeshWarning& warning : warnings) counts[warning.code] += warning.count;
    return counts;
}

void expect_read(const Result<mesh::ReadMeshResult>& read, const ModelCase& expected) {
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices.size(), expected.vertices);
    EXPECT_EQ(read->mesh.face_count, expected.faces);
    EXPECT_EQ(read->mesh.triangles.size(), expected.triangles);
    EXPECT_EQ(counted(read->warnings), expected.warnings);
    if (expected.area) {
        EXPECT_NEAR(mesh::measure(read->mesh).surface_area, *expected.area, 1e-6);
    }
    if (expected.colours) {
        EXPECT_EQ(colours_text(read->mesh), *expected.colours);
    }
    if (expected.metres_per_unit) {
        EXPECT_NEAR(read->metres_per_unit, *expected.metres_per_unit, 1e-9);
    }
    if (expected.up) {
        ASSERT_TRUE(read->up);
        EXPECT_EQ("xyz"[static_cast<int>(*read->up)], *expected.up);
    }
    expect_whole(read->mesh);
}

void expect_refused(const Result<mesh::ReadMeshResult>& read, const ModelCase& expected,
                    const std::string& name) {
    ASSERT_FALSE(read);
    const std::string& message = read.error().message;
    EXPECT_EQ(to_string(read.error().code), expected.code) << message;
    for (const std::string& part : expected.says) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
    EXPECT_EQ(message.rfind(name, 0), 0u) << message;
}

void expect_line(const std::string& message, const ModelCase& expected) {
    const std::string line = "line " + std::to_string(expected.line) + ":";
    EXPECT_EQ(message.find(line) != std::string::npos, expected.line > 0) << message;
    for (const char c : message) EXPECT_TRUE(c >= ' ' && c <= '~') << message;
}

void expect_whole(const mesh::TriangleMesh& mesh) {
    ASSERT_EQ(mesh.face_of_triangle.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        ASSERT_LT(mesh.face_of_triangle[t], mesh.face_count);
        for (const std::uint32_t vertex : mesh.triangles[t]) {
            ASSERT_LT(vertex, mesh.vertices.size());
        }
    }
    for (const Vec3& vertex : mesh.vertices) ASSERT_TRUE(vertex.allFinite());
}

}  // namespace ossuary::test
