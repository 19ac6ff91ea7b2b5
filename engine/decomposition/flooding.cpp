#include "engine/decomposition/flooding.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ossuary::decomposition {
namespace {

constexpr int kMeanShiftSteps = 8;

/// The label of the labelled neighbour whose normal is closest.
std::uint32_t closest_label(const VertexGraph& surface, const std::vector<std::uint32_t>& labels,
                            std::uint32_t vertex) {
    std::uint32_t label = kUnlabeled;
    double closest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t n : surface.around(vertex)) {
        if (labels[n] == kUnlabeled) continue;
        const double cosine = surface.normals[n].dot(surface.normals[vertex]);
        if (cosine <= closest) continue;
        closest = cosine;
        label = labels[n];
    }
    return label;
}

bool on_border(const VertexGraph& surface, const std::vector<std::uint32_t>& labels,
               std::uint32_t vertex) {
    for (const std::uint32_t n : surface.around(vertex)) {
        if (labels[n] != labels[vertex]) return true;
    }
    return false;
}

/// The vertex itself and those within two edges, each once or, over two ways, more often.
std::vector<std::uint32_t> two_rings(const VertexGraph& surface, std::uint32_t vertex) {
    std::vector<std::uint32_t> rings = {vertex};
    for (const std::uint32_t n : surface.around(vertex)) {
        rings.push_back(n);
        for (const std::uint32_t m : surface.around(n)) {
            if (m != vertex) rings.push_back(m);
        }
    }
    return rings;
}

std::uint32_t consistent_label(const VertexGraph& surface, const std::vector<std::uint32_t>& labels,
                               std::uint32_t vertex, double bandwidth) {
    const std::vector<std::uint32_t> rings = two_rings(surface, vertex);
    const auto kernel = [&](std::uint32_t v, double mode) {
        const double away = (surface.curvatures[v] - mode) / bandwidth;
        return std::exp(-0.5 * away * away);
    };
    double mode = surface.curvatures[vertex];
    for (int step = 0; step < kMeanShiftSteps; ++step) {
        double sum = 0.0, weight = 0.0;
        for (const std::uint32_t v : rings) {
            const double w = kernel(v, mode);
            sum += w * surface.curvatures[v];
            weight += w;
        }
        if (weight <= 0.0) break;
        mode = sum / weight;
    }
    std::map<std::uint32_t, double> votes;
    for (const std::uint32_t v : rings) votes[labels[v]] += kernel(v, mode);
    std::uint32_t label = labels[vertex];
    for (const auto& [candidate, vote] : votes) {
        if (vote > votes[label]) label = candidate;
    }
    return label;
}

}  // namespace

void flood_labels(const VertexGraph& surface, std::vector<std::uint32_t>& labels) {
    std::vector<std::uint32_t> shore;
    std::vector<bool> listed(surface.size(), false);
    const auto list_around = [&](std::uint32_t vertex, std::vector<std::uint32_t>& list) {
        for (const std::uint32_t n : surface.around(vertex)) {
            if (labels[n] != kUnlabeled || listed[n]) continue;
            listed[n] = true;
            list.push_back(n);
        }
    };
    for (std::uint32_t v = 0; v < surface.size(); ++v) {
        if (labels[v] != kUnlabeled) list_around(v, shore);
    }
    while (!shore.empty()) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> flooded;
        for (const std::uint32_t v : shore) {
            flooded.emplace_back(v, closest_label(surface, labels, v));
        }
        for (const auto& [v, label] : flooded) labels[v] = label;
        shore.clear();
        for (const auto& [v, label] : flooded) list_around(v, shore);
    }
}

void refine_by_curvature(const VertexGraph& surface, std::vector<std::uint32_t>& labels,
                         const CurvatureConsistencyOptions& options) {
    for (int round = 0; round < options.rounds; ++round) {
        std::vector<std::uint32_t> refined = labels;
        for (std::uint32_t v = 0; v < surface.size(); ++v) {
            if (!on_border(surface, labels, v)) continue;
            refined[v] = consistent_label(surface, labels, v, options.bandwidth);
        }
        if (refined == labels) break;
        labels = std::move(refined);
    }
}

}  // namespace ossuary::decomposition
