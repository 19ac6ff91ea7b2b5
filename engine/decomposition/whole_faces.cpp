#include "engine/decomposition/whole_faces.h"

#include <map>

namespace ossuary::decomposition {

std::size_t count_faces(const SurfaceGraph& surface) {
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < surface.size(); ++t) count += surface.first_of_face[t] == t;
    return count;
}

void label_whole_faces(const SurfaceGraph& surface, std::vector<std::uint32_t>& labels) {
    // Faces whose triangles agree, which are nearly all, need no sums.
    std::map<std::uint32_t, std::map<std::uint32_t, double>> split;
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        if (labels[t] != labels[surface.first_of_face[t]]) split[surface.first_of_face[t]];
    }
    if (split.empty()) return;
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        const auto face = split.find(surface.first_of_face[t]);
        if (face != split.end()) face->second[labels[t]] += surface.areas[t];
    }
    std::map<std::uint32_t, std::uint32_t> chosen;
    for (const auto& [face, areas] : split) {
        double most = 0.0;
        chosen[face] = labels[face];
        for (const auto& [label, area] : areas) {
            if (area <= most) continue;
            most = area;
            chosen[face] = label;
        }
    }
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
        const auto face = chosen.find(surface.first_of_face[t]);
        if (face != chosen.end()) labels[t] = face->second;
    }
}

}  // namespace ossuary::decomposition
