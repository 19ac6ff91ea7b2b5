// CGAL's mean curvature flow skeletonization with its defaults (Tagliasacchi et al., "Mean
// curvature skeletons", 2012), on one thread: one JSON document a line on stdout.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <ctime>
#include <filesystem>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<Mesh>;

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string name = std::filesystem::path(argv[i]).stem().string();
        std::vector<Kernel::Point_3> points;
        std::vector<std::vector<std::size_t>> faces;
        if (!CGAL::IO::read_polygon_soup(argv[i], points, faces)) return 1;
        CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
        Mesh mesh;
        CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, mesh);
        if (!CGAL::is_closed(mesh)) {
            std::cout << "{\"model\": \"" << name << "\", \"refused\": \"not closed\"}"
                      << std::endl;
            continue;
        }
        const std::clock_t begin = std::clock();
        Skeletonization::Skeleton skeleton;
        CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
        const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        std::cout << "{\"model\": \"" << name << "\", \"vertices\": " << num_vertices(skeleton)
                  << ", \"ms\": " << ms << "}" << std::endl;
    }
}
