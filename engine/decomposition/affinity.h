#pragma once

#include <vector>

#include "engine/decomposition/pair_features.h"

namespace ossuary::decomposition {

/// The probability that people put the two patches into one part, for each pair of patches: a
/// logistic function of their features. Its weights were fitted to the human segmentations of the
/// ten classes of the thesis (tests/benchmarks/fit_affinity.cpp), and to those only; they know
/// nothing of classes, so that the others tell how far they carry.
std::vector<float> probability_together(const PatchPairs& pairs);

}  // namespace ossuary::decomposition
