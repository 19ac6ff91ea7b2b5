#pragma once

#include "engine/core/geometry.h"
#include "engine/descriptor/shell_graph.h"

namespace ossuary::descriptor {

/// Where a surface's centre of gravity is and how far the surface is from it in the mean.
struct ShellCenter {
    Vec3f center = Vec3f::Zero();
    double mean_distance = 0.0;
};

inline ShellCenter shell_center(const ShellGraph& graph) {
    ShellCenter result;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < graph.size(); ++i) {
        sum += static_cast<double>(graph.areas[i]) * graph.points[i].cast<double>();
    }
    if (graph.total_area > 0.0) sum /= graph.total_area;
    result.center = sum.cast<float>();
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const double distance = (graph.points[i].cast<double>() - sum).norm();
        result.mean_distance += static_cast<double>(graph.areas[i]) * distance;
    }
    if (graph.total_area > 0.0) result.mean_distance /= graph.total_area;
    return result;
}

}  // namespace ossuary::descriptor
