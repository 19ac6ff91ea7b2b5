// CGAL's shape-diameter segmentation with its defaults, and ours, on the same models in one run:
//   ossuary_peer_cgal MODELS_DIR OUT_DIR [STRIDE]
// Every STRIDE-th N.off (by number) is cut by both; OUT_DIR/N.seg has CGAL's labels, for
// `ossuary evaluate-segmentation --segmentations OUT_DIR`; stdout has the processor time of each.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "engine/decomposition/decompose.h"
#include "engine/mesh/read_mesh.h"

namespace {

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = boost::graph_traits<Surface>::face_descriptor;

/// Milliseconds of processor time that this thread has used.
double thread_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// False where the mesh does not fit into CGAL's halfedges.
bool to_cgal(const ossuary::TriangleMesh& mesh, Surface& surface) {
    for (const auto& p : mesh.vertices) surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
    for (const auto& t : mesh.triangles) {
        using Vertex = Surface::Vertex_index;
        if (surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == Surface::null_face()) {
            return false;
        }
    }
    return true;
}

std::string segment_with_cgal(Surface& surface) {
    auto diameters = surface.add_property_map<Face, double>("f:sdf").first;
    auto segments = surface.add_property_map<Face, std::size_t>("f:segment").first;
    CGAL::sdf_values(surface, diameters);
    CGAL::segmentation_from_sdf_values(surface, diameters, segments);
    std::string text;
    for (const Face face : faces(surface)) text += std::to_string(segments[face]) + "\n";
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: ossuary_peer_cgal MODELS_DIR OUT_DIR [STRIDE]\n";
        return 2;
    }
    const int stride = argc > 3 ? std::max(1, std::stoi(argv[3])) : 1;
    fs::create_directories(argv[2]);
    std::cout << "model,faces,ours_ms,cgal_ms\n";
    double ours_sum = 0.0, cgal_sum = 0.0;
    int models = 0, place = 0;
    for (int number = 1; number <= 1000; ++number) {
        const fs::path path = fs::path(argv[1]) / (std::to_string(number) + ".off");
        if (!fs::exists(path) || place++ % stride != 0) continue;
        const auto read = ossuary::read_mesh(path);
        Surface surface;
        if (!read.ok() || !to_cgal(read->mesh, surface)) {
            std::cerr << path << ": left out\n";
            continue;
        }
        double start = thread_ms();
        const auto ours = ossuary::decompose(read->mesh);
        const double ours_ms = thread_ms() - start;
        start = thread_ms();
        const std::string labels = segment_with_cgal(surface);
        const double cgal_ms = thread_ms() - start;
        std::ofstream(fs::path(argv[2]) / (std::to_string(number) + ".seg")) << labels;
        std::cout << fmt::format("{},{},{:.1f},{:.1f}\n", number, read->mesh.triangles.size(),
                                 ours_ms, cgal_ms)
                  << std::flush;
        ours_sum += ours_ms;
        cgal_sum += cgal_ms;
        ++models;
    }
    if (models == 0) return 1;
    std::cerr << fmt::format(
        "{} models: ours {:.1f} ms, CGAL {:.0f} ms in the mean; {:.0f} times\n", models,
        ours_sum / models, cgal_sum / models, cgal_sum / ours_sum);
    return 0;
}
