#include "tests/benchmarks/workload.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>

#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::benchmarks {
namespace {

std::vector<Workload> make_workloads() {
    std::vector<Workload> all;
    const auto add_built = [&](const char* name, mesh::TriangleMesh mesh) {
        std::string off = mesh::to_off(mesh);
        all.push_back({name, std::move(mesh), std::move(off)});
    };
    add_built("torus", test::torus_mesh(2.0, 0.6));
    add_built("capsule_tree", test::capsule_tree_mesh());

    const auto data = test::benchmark_data();
    if (!data) {
        std::fputs("benchmark data not found (set OSSUARY_DATA): built shapes only\n", stderr);
        return all;
    }
    for (const auto& [name, number] :
         {std::pair{"human", 1}, std::pair{"cup", 21}, std::pair{"ant", 81}, std::pair{"hand", 181},
          std::pair{"armadillo", 281}}) {
        const auto path = *data / "princeton-segmentation" / "off" / fmt::format("{}.off", number);
        std::ifstream file(path, std::ios::binary);
        std::string off((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        auto read = mesh::read_mesh(off, path.string());
        if (!read.ok()) {
            std::fprintf(stderr, "%s\n", read.error().message.c_str());
            std::exit(1);
        }
        all.push_back({name, std::move(read->mesh), std::move(off)});
    }
    return all;
}

}  // namespace

const std::vector<Workload>& workloads() {
    static const std::vector<Workload> all = make_workloads();
    return all;
}

}  // namespace ossuary::benchmarks
