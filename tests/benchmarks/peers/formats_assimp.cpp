// How fast binary STL, OBJ and binary PLY are read, ours against assimp's, in the same run.
//
// Usage: ossuary_peer_formats [TRIANGLES] [RUNS]     (default 500000 triangles, best of 5 runs)
//
// Both read the same file, warm, and then sum up the area of its triangles. Processor seconds.
// "reader" is the format's reader alone, "read_mesh" with what it says of the surface besides;
// assimp is asked to cut polygons into triangles, and "joined" to give equal positions one vertex
// as well, without which an STL file is a heap of triangles that know no neighbours. Ours always
// does that for STL.

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "engine/mesh/read_mesh.h"
#include "engine/mesh/read_obj.h"
#include "engine/mesh/read_ply.h"
#include "engine/mesh/read_stl.h"
#include "engine/mesh/write_mesh.h"

namespace {

using ossuary::Vec3;
using ossuary::mesh::TriangleMesh;
using Reader = ossuary::Result<ossuary::mesh::ReadMeshResult> (*)(
    std::string_view, std::string_view, const ossuary::mesh::ReadMeshOptions&,
    const std::stop_token&);

/// A torus with a relief, so that coordinates have many digits.
TriangleMesh torus(std::size_t triangles) {
    const auto around = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles)));
    const auto across = static_cast<std::uint32_t>(triangles / 2 / around);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around,
                         v = 2 * std::numbers::pi * j / across;
            const double r = 0.3 + 0.02 * std::sin(40 * u) * std::cos(30 * v);
            const Vec3 at((1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u),
                          r * std::sin(v));
            mesh.vertices.push_back(at.cast<float>().cast<double>());
            const std::uint32_t k = (i + 1) % around, l = (j + 1) % across;
            const std::uint32_t a = i * across + j, b = k * across + j, c = k * across + l,
                                d = i * across + l;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    return mesh;
}

/// As most programs write it: floats, little-endian.
std::string to_float_ply(const TriangleMesh& mesh) {
    std::string ply = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face {}\nproperty list uchar int "
        "vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.triangles.size());
    const auto append = [&](const auto& value) {
        ply.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    for (const Vec3& vertex : mesh.vertices) {
        for (const double x : vertex) append(static_cast<float>(x));
    }
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        append(std::uint8_t{3});
        append(triangle);
    }
    return ply;
}

/// As most programs write it: no more digits than floats need.
std::string to_float_obj(const TriangleMesh& mesh) {
    std::string obj;
    for (const Vec3& vertex : mesh.vertices) {
        const Eigen::Vector3f at = vertex.cast<float>();
        obj += fmt::format("v {} {} {}\n", at.x(), at.y(), at.z());
    }
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        obj += fmt::format("f {} {} {}\n", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1);
    }
    return obj;
}

struct Recount {
    std::size_t triangles = 0;
    double area = 0;
};

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Recount recount(const ossuary::Result<ossuary::mesh::ReadMeshResult>& read) {
    if (!read) {
        fmt::print(stderr, "{}\n", read.error().message);
        std::exit(1);
    }
    Recount count{read->mesh.triangles.size(), 0};
    for (const TriangleMesh::Triangle& triangle : read->mesh.triangles) {
        const Vec3& a = read->mesh.vertices[triangle[0]];
        const Vec3 b = read->mesh.vertices[triangle[1]] - a;
        const Vec3 c = read->mesh.vertices[triangle[2]] - a;
        count.area += b.cross(c).norm() / 2;
    }
    return count;
}

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::filesystem::file_size(path), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

Recount by_assimp(const std::string& path, unsigned flags) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate | flags);
    Recount count;
    if (scene == nullptr) return count;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) continue;
            const unsigned* corner = mesh.mFaces[f].mIndices;
            const aiVector3D a = mesh.mVertices[corner[0]];
            const aiVector3D b = mesh.mVertices[corner[1]] - a, c = mesh.mVertices[corner[2]] - a;
            ++count.triangles;
            count.area += static_cast<double>((b ^ c).Length()) / 2;
        }
    }
    return count;
}

/// The best of several runs.
double best(int runs, const std::function<Recount()>& read, std::size_t triangles) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        const double start = seconds();
        const Recount count = read();
        least = std::min(least, seconds() - start);
        if (count.triangles != triangles) {
            fmt::print(stderr, "expected {} triangles, found {}\n", triangles, count.triangles);
        }
    }
    return least;
}

void compare(const std::string& name, Reader reader, const std::string& bytes, int runs,
             std::size_t triangles) {
    const std::string path =
        (std::filesystem::temp_directory_path() / ("ossuary_peer_formats." + name)).string();
    std::ofstream(path, std::ios::binary) << bytes;
    const double copy = best(
        runs,
        [&] {
            const std::string copied = contents(path);
            return Recount{triangles, static_cast<double>(copied.back())};
        },
        triangles);
    const double alone = best(
        runs, [&] { return recount(reader(contents(path), path, {}, {})); }, triangles);
    const double whole = best(
        runs, [&] { return recount(ossuary::mesh::read_mesh(std::filesystem::path(path))); },
        triangles);
    const double theirs = best(
        runs, [&] { return by_assimp(path, 0); }, triangles);
    const double joined = best(
        runs, [&] { return by_assimp(path, aiProcess_JoinIdenticalVertices); }, triangles);
    fmt::print("{:4} {:7.1f} {:9.4f} {:9.4f} {:9.4f} {:9.4f} {:9.4f} {:7.1f} {:7.1f}\n", name,
               static_cast<double>(bytes.size()) / 1e6, copy, alone, whole, theirs, joined,
               theirs / alone, joined / alone);
    std::filesystem::remove(path);
}

}  // namespace

int main(int count, char** arguments) {
    const std::size_t wanted = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 500'000;
    const int runs = count > 2 ? std::atoi(arguments[2]) : 5;
    const TriangleMesh mesh = torus(wanted);
    const std::size_t triangles = mesh.triangles.size();
    fmt::print("{} triangles, best of {} runs, processor seconds\n", triangles, runs);
    fmt::print("          MB file only    reader read_mesh    assimp    joined   ratio  joined\n");
    compare("stl", ossuary::mesh::read_stl, ossuary::mesh::to_stl(mesh), runs, triangles);
    compare("obj", ossuary::mesh::read_obj, to_float_obj(mesh), runs, triangles);
    compare("ply", ossuary::mesh::read_ply, to_float_ply(mesh), runs, triangles);
    return 0;
}
