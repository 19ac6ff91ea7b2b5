// Different shapes by the thousand, for large collections: models that are read from files, and
// built ones, are stretched, bent, twisted and tapered, and every third is united with another that
// is treated likewise. The same for the same seed and files.
//   ossuary_scale_shapes OUT COUNT SEED FOLDER…   writes OUT/NNN/shape-NNNNNN.off, and
//   OUT/shapes.cla
// with a class for each original.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace {

using namespace ossuary;
using test::next_unit;
namespace fs = std::filesystem;

/// Larger ones would only make reading slow.
constexpr std::size_t kMostTriangles = 60'000;
constexpr std::size_t kShapesPerFolder = 1000;

struct Original {
    std::string name;
    mesh::TriangleMesh mesh;  ///< its bounding box's centre at the origin, longest side 1
};

mesh::TriangleMesh centred(const mesh::TriangleMesh& mesh) {
    const Box3 bounds = mesh::measure(mesh).bounds;
    const double side = std::max(bounds.sizes().maxCoeff(), 1e-12);
    return test::transformed(mesh, Mat3::Identity() / side, -bounds.center() / side);
}

std::vector<Original> read_originals(const std::vector<fs::path>& folders) {
    std::vector<fs::path> files;
    for (const fs::path& folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() == ".off") files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<Original> originals;
    for (const fs::path& file : files) {
        const auto read = mesh::read_mesh(file);
        if (!read || read->mesh.empty() || read->mesh.triangles.size() > kMostTriangles) continue;
        originals.push_back({file.stem().string(), centred(read->mesh)});
    }
    for (const test::MeshShape& shape : test::mesh_shapes()) {
        originals.push_back({shape.name, centred(shape.mesh)});
    }
    return originals;
}

double between(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * next_unit(random);
}

/// Stretched, tapered, twisted and bent along an axis of its own.
mesh::TriangleMesh deformed(const mesh::TriangleMesh& original, std::mt19937_64& random) {
    const Mat3 frame = test::random_rotation(random());
    const Vec3 stretch(std::exp(between(random, -0.5, 0.5)), std::exp(between(random, -0.5, 0.5)),
                       std::exp(between(random, -0.5, 0.5)));
    const double taper = between(random, -0.5, 0.5);
    const double twist = between(random, -1.2, 1.2);
    const double bend = between(random, -1.5, 1.5);
    mesh::TriangleMesh mesh = original;
    for (Vec3& vertex : mesh.vertices) {
        Vec3 at = stretch.cwiseProduct(frame * vertex);
        at.head<2>() *= 1.0 + taper * at.z();
        at = Eigen::AngleAxisd(twist * at.z(), Vec3::UnitZ()) * at;
        if (std::abs(bend) > 1e-3) {  // onto an arc about the y axis
            const double radius = 1.0 / bend;
            const double angle = bend * at.z();
            const double from_centre = radius - at.x();
            at =
                Vec3(radius - from_centre * std::cos(angle), at.y(), from_centre * std::sin(angle));
        }
        vertex = frame.transpose() * at;
    }
    return centred(mesh);
}

/// A shape and the original that names its class.
struct Shape {
    std::size_t original = 0;
    mesh::TriangleMesh mesh;
};

Shape make_shape(const std::vector<Original>& originals, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const std::size_t first = test::next_below(random, originals.size());
    Shape shape{first, deformed(originals[first].mesh, random)};
    if (next_unit(random) > 1.0 / 3.0) return shape;
    const std::size_t second = test::next_below(random, originals.size());
    const mesh::TriangleMesh other = deformed(originals[second].mesh, random);
    const std::size_t at = test::next_below(random, shape.mesh.vertices.size());
    shape.mesh = test::merged(shape.mesh,
                              test::transformed(other, Mat3::Identity() * between(random, 0.3, 0.8),
                                                shape.mesh.vertices[at]));
    return shape;
}

Result<void> write_shapes(const std::vector<Original>& originals, const fs::path& out,
                          std::size_t count, std::uint64_t seed) {
    std::map<std::size_t, std::vector<std::string>> classes;
    for (std::size_t i = 0; i < count; ++i) {
        const Shape shape = make_shape(originals, seed + i);
        const std::string name = fmt::format("shape-{:06}", i);
        const fs::path folder = out / fmt::format("{:03}", i / kShapesPerFolder);
        fs::create_directories(folder);
        if (auto written = mesh::write_off(shape.mesh, folder / (name + ".off")); !written) {
            return written;
        }
        classes[shape.original].push_back(name);
    }
    std::ofstream cla(out / "shapes.cla");
    cla << fmt::format("PSB 1\n{} {}\n", classes.size(), count);
    for (const auto& [original, members] : classes) {
        cla << fmt::format("\n{}-{} 0 {}\n", originals[original].name, original, members.size());
        for (const std::string& member : members) cla << member << '\n';
    }
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::cerr << "usage: ossuary_scale_shapes OUT COUNT SEED FOLDER...\n";
        return 2;
    }
    const auto originals = read_originals({argv + 4, argv + argc});
    const auto written = write_shapes(originals, argv[1], std::strtoull(argv[2], nullptr, 10),
                                      std::strtoull(argv[3], nullptr, 10));
    if (written) return 0;
    std::cerr << written.error().message << '\n';
    return 1;
}
