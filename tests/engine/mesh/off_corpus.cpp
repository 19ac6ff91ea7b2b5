#include "tests/engine/mesh/off_corpus.h"

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

OffCase read_case(const fs::path& path) {
    OffCase off_case;
    off_case.name = path.stem().string();
    off_case.bytes = contents(path);
    std::istringstream lines(contents(fs::path(path).replace_extension(".expect")));
    for (std::string key; lines >> key;) {
        if (key == "vertices") {
            lines >> off_case.vertices;
        } else if (key == "faces") {
            lines >> off_case.faces;
        } else if (key == "triangles") {
            lines >> off_case.triangles;
        } else if (key == "warning") {
            std::string code;
            lines >> code >> off_case.warnings[code];
        } else if (key == "code") {
            lines >> off_case.code;
        } else if (key == "line") {
            lines >> off_case.line;
        } else if (key == "says") {
            std::getline(lines >> std::ws, off_case.says);
        } else {
            throw std::runtime_error(path.string() + ": unknown expectation " + key);
        }
    }
    return off_case;
}

}  // namespace

void PrintTo(const OffCase& off_case, std::ostream* out) { *out << off_case.name; }

std::vector<OffCase> off_cases(const std::string& folder) {
    std::vector<OffCase> cases;
    const fs::path root = source_folder() / "tests" / "corpus" / "off" / folder;
    for (const auto& entry : fs::directory_iterator(root)) {
        if (entry.path().extension() == ".off") cases.push_back(read_case(entry.path()));
    }
    std::sort(cases.begin(), cases.end(),
              [](const OffCase& a, const OffCase& b) { return a.name < b.name; });
    return cases;
}

}  // namespace ossuary::test
