#include "index/cli/wavefront_lines.h"

#include <fmt/format.h>

namespace ossuary::cli {

std::string wavefront_lines(const skeleton::SkeletonGraph& graph) {
    std::string vertices = "# curve skeleton: one polyline a branch\n";
    std::string lines;
    std::size_t next = 1;  // .obj counts from 1
    for (const auto& node : graph.nodes) {
        if (node.degree > 0) continue;
        vertices +=
            fmt::format("v {} {} {}\n", node.position.x(), node.position.y(), node.position.z());
        lines += fmt::format("p {}\n", next++);
    }
    for (const auto& branch : graph.branches) {
        lines += "l";
        for (const Vec3& point : branch.points) {
            vertices += fmt::format("v {} {} {}\n", point.x(), point.y(), point.z());
            lines += fmt::format(" {}", next++);
        }
        lines += "\n";
    }
    return vertices + lines;
}

}  // namespace ossuary::cli
