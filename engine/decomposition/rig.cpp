#include "engine/decomposition/rig.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/decomposition/branch_mapping.h"
#include "engine/decomposition/vertex_graph.h"

namespace ossuary::decomposition {
namespace {

using Spread = std::vector<std::pair<std::uint16_t, float>>;  // joint and weight, by joint

/// Adds the joints, each after its parent; returns the joint of each branch.
std::vector<std::uint16_t> add_joints(const skeleton::SkeletonGraph& skeleton, Rig& rig) {
    std::vector<std::uint16_t> of_branch(skeleton.branches.size(), 0);
    std::vector<bool> has_joint(skeleton.branches.size(), false);
    std::vector<bool> reached(skeleton.nodes.size(), false);
    const auto grow_from = [&](std::uint32_t root, std::uint16_t root_joint) {
        std::vector<std::pair<std::uint32_t, std::uint16_t>> open = {{root, root_joint}};
        reached[root] = true;
        for (std::size_t next = 0; next < open.size(); ++next) {
            const auto [node, joint] = open[next];
            bool is_tip = node != root;
            for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
                const skeleton::SkeletonGraph::Branch& branch = skeleton.branches[b];
                if (has_joint[b] || (branch.a != node && branch.b != node)) continue;
                has_joint[b] = true;
                is_tip = false;
                of_branch[b] = static_cast<std::uint16_t>(rig.joints.size());
                rig.joints.push_back(
                    {skeleton.nodes[node].position, joint, static_cast<std::int32_t>(b)});
                const std::uint32_t other = branch.a == node ? branch.b : branch.a;
                if (reached[other]) continue;
                reached[other] = true;
                open.emplace_back(other, of_branch[b]);
            }
            if (is_tip) rig.joints.push_back({skeleton.nodes[node].position, joint, -1});
        }
    };
    std::uint32_t thickest = 0;
    for (std::uint32_t n = 1; n < skeleton.nodes.size(); ++n) {
        if (skeleton.nodes[n].radius > skeleton.nodes[thickest].radius) thickest = n;
    }
    rig.joints.push_back({});
    if (!skeleton.nodes.empty()) {
        rig.joints[0].position = skeleton.nodes[thickest].position;
        grow_from(thickest, 0);
    }
    for (std::uint32_t n = 0; n < skeleton.nodes.size(); ++n) {
        if (!reached[n]) grow_from(n, 0);  // other pieces of the skeleton hang on the first joint
    }
    return of_branch;
}

/// One half of each vertex's own weights, the other half of its neighbours' mean.
void spread_once(const VertexGraph& surface, std::vector<Spread>& spreads,
                 const std::stop_token& stop) {
    std::vector<Spread> result(spreads.size());
    for (std::uint32_t v = 0; v < spreads.size() && !stop.stop_requested(); ++v) {
        const auto around = surface.around(v);
        if (around.empty()) {
            result[v] = spreads[v];
            continue;
        }
        std::map<std::uint16_t, float> sum;
        for (const auto& [joint, weight] : spreads[v]) sum[joint] += 0.5F * weight;
        const float share = 0.5F / static_cast<float>(around.size());
        for (const std::uint32_t n : around) {
            for (const auto& [joint, weight] : spreads[n]) sum[joint] += share * weight;
        }
        result[v].assign(sum.begin(), sum.end());
    }
    spreads = std::move(result);
}

Rig::Weights largest(Spread spread) {
    std::stable_sort(spread.begin(), spread.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    if (spread.size() > Rig::kInfluences) spread.resize(Rig::kInfluences);
    float sum = 0.0F;
    for (const auto& entry : spread) sum += entry.second;
    Rig::Weights weights;
    for (std::size_t k = 0; k < spread.size(); ++k) {
        weights.joints[k] = spread[k].first;
        weights.weights[k] = spread[k].second / sum;
    }
    return weights;
}

}  // namespace

Rig make_rig(const mesh::TriangleMesh& mesh, const skeleton::SkeletonGraph& skeleton, int smoothing,
             const std::stop_token& stop) {
    Rig rig;
    const std::vector<std::uint16_t> joint_of_branch = add_joints(skeleton, rig);
    const VertexGraph surface = vertex_graph(mesh);
    std::vector<Spread> spreads(mesh.vertices.size(), Spread{{std::uint16_t{0}, 1.0F}});
    if (!skeleton.branches.empty()) {
        const BranchMapping mapping(skeleton);
        for (std::size_t v = 0; v < spreads.size() && !stop.stop_requested(); ++v) {
            const std::uint32_t branch = mapping.branch_of(mesh.vertices[v], surface.normals[v]);
            spreads[v][0].first = joint_of_branch[branch];
        }
    }
    for (int round = 0; round < smoothing; ++round) spread_once(surface, spreads, stop);
    if (stop.stop_requested()) return rig;
    for (Spread& spread : spreads) rig.weights.push_back(largest(std::move(spread)));
    return rig;
}

}  // namespace ossuary::decomposition
