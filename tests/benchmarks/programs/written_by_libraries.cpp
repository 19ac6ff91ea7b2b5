// Writes models with CGAL and OpenMesh, as programs on these libraries do.
//   ossuary_written_by_libraries FOLDER MODEL.off…   as FOLDER/PROGRAM-VARIANT/NAME.EXTENSION
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Variant {
    const char* name;
    const char* extension;
    bool binary;
};

/// A place for a model as a variant writes it.
std::string place(const fs::path& folder, const std::string& program, const Variant& variant,
                  const fs::path& model) {
    const fs::path to = folder / (program + "-" + variant.name);
    fs::create_directories(to);
    return (to / model.stem()).string() + variant.extension;
}

bool write_with_cgal(const fs::path& folder, const fs::path& model) {
    using Point = CGAL::Simple_cartesian<double>::Point_3;
    constexpr std::array<Variant, 6> kVariants = {{{"off", ".off", false},
                                                   {"obj", ".obj", false},
                                                   {"stl", ".stl", true},
                                                   {"stl-text", ".stl", false},
                                                   {"ply", ".ply", true},
                                                   {"ply-text", ".ply", false}}};
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(model.string(), points, faces)) return false;
    bool fine = true;
    for (const Variant& variant : kVariants) {
        fine &= CGAL::IO::write_polygon_soup(place(folder, "cgal", variant, model), points, faces,
                                             CGAL::parameters::use_binary_mode(variant.binary));
    }
    return fine;
}

bool write_with_openmesh(const fs::path& folder, const fs::path& model) {
    constexpr std::array<Variant, 7> kVariants = {{{"off", ".off", false},
                                                   {"off-binary", ".off", true},
                                                   {"obj", ".obj", false},
                                                   {"stl", ".stl", true},
                                                   {"stl-text", ".stl", false},
                                                   {"ply", ".ply", true},
                                                   {"ply-text", ".ply", false}}};
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    if (!OpenMesh::IO::read_mesh(mesh, model.string())) return false;
    mesh.request_face_normals();
    mesh.update_face_normals();
    bool fine = true;
    for (const Variant& variant : kVariants) {
        OpenMesh::IO::Options options;
        if (variant.binary) options += OpenMesh::IO::Options::Binary;
        fine &= OpenMesh::IO::write_mesh(mesh, place(folder, "openmesh", variant, model), options);
    }
    return fine;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: ossuary_written_by_libraries FOLDER MODEL.off…\n";
        return 2;
    }
    bool fine = true;
    for (int i = 2; i < argc; ++i) {
        fine &= write_with_cgal(argv[1], argv[i]);
        fine &= write_with_openmesh(argv[1], argv[i]);
    }
    return fine ? 0 : 1;
}
