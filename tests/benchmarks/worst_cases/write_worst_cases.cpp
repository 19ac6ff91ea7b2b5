// Writes the worst cases of tests/support/worst_cases.h as OFF files:
//   ossuary_worst_cases FOLDER [--small] [NAME…]
// without names all of them. run_worst_cases.py measures the programs on them.
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "engine/mesh/write_mesh.h"
#include "tests/support/worst_cases.h"

int main(int argc, char** argv) {
    using namespace ossuary;
    std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.empty() || arguments.front().starts_with('-')) {
        std::cerr << "usage: ossuary_worst_cases FOLDER [--small] [NAME…]\n";
        return 2;
    }
    const std::filesystem::path folder = arguments.front();
    arguments.erase(arguments.begin());
    const bool small = std::erase(arguments, "--small") > 0;
    std::filesystem::create_directories(folder);
    for (const test::WorstCase& worst : test::worst_cases()) {
        const std::string name(worst.name);
        const bool named = std::find(arguments.begin(), arguments.end(), name) != arguments.end();
        if (!arguments.empty() && !named) continue;
        const mesh::TriangleMesh mesh = worst.build(small ? worst.small : worst.full);
        const auto path = folder / (name + ".off");
        if (const auto written = mesh::write_off(mesh, path); !written) {
            std::cerr << written.error().message << '\n';
            return 1;
        }
        std::cout << path.string() << ": " << mesh.triangles.size() << " triangles\n";
    }
    return 0;
}
