#include "engine/decomposition/affinity.h"

#include <cmath>

namespace ossuary::decomposition {
namespace {

// In the order of PairFeature. On the ten classes, each class judged by weights that were fitted
// without it, nets of 4 and 16 hidden units reach a Rand index error of .098 where this reaches
// .114, but on the other nine .177 and .172 instead of .142: they learn the classes they see.
constexpr PairFeatures kWeights = {
    1.3326F,   // thickness_least
    -1.9873F,  // thickness_most
    0.4356F,   // thickness_neck
    -2.8244F,  // thickness_bulge
    -0.5799F,  // thickness_step
    2.2404F,   // distance
    1.9762F,   // geodesic
    0.9329F,   // detour
    -2.4730F,  // concave_way
    1.4208F,   // concave_density
    2.8004F,   // concave_barrier
    3.5708F,   // crease_barrier
    0.6672F,   // resistance
    -0.3868F,  // resistance_far
    -1.6377F,  // crease_resistance
    -2.3976F,  // crease_resistance_far
    -0.0309F,  // outside_middle
    0.3473F,   // outside_near
    -1.8553F,  // outside_length
    -0.2957F,  // skeleton_way
    1.1566F,   // skeleton_neck
    -0.1713F,  // skeleton_bulge
    0.0764F,   // skeleton_junctions
    0.4510F,   // same_branch
    0.3247F,   // radius_least
    -0.0460F,  // radius_most
    4.6648F,   // reach_least
    2.9382F,   // reach_most
    1.0897F,   // centrality_least
    1.5306F,   // centrality_most
    0.1257F,   // normals
};
constexpr float kConstant = 0.9144F;

}  // namespace

std::vector<float> probability_together(const PatchPairs& pairs) {
    std::vector<float> together;
    together.reserve(pairs.features.size());
    for (const PairFeatures& features : pairs.features) {
        float sum = kConstant;
        for (std::size_t k = 0; k < features.size(); ++k) sum += kWeights[k] * features[k];
        together.push_back(1.0F / (1.0F + std::exp(-sum)));
    }
    return together;
}

}  // namespace ossuary::decomposition
