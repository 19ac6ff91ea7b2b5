#include "tests/engine/mesh/model_corpus.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

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

void PrintTo(const ModelCase& model_case, std::ostream* out) { *out << model_case.name; }

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

}  // namespace ossuary::test
