#pragma once

#include <cstdint>
#include <vector>

#include "engine/descriptor/model_descriptor.h"
#include "engine/ranking/ranker.h"

namespace ossuary::test {

/// A body of three to six limbs on a trunk, described by the real stages from a volume and a
/// skeleton that are both built from the same capsules. The same for the same family and seed;
/// models of one family have the same limbs, a little changed.
descriptor::ModelDescriptor built_model(std::uint64_t family, std::uint64_t seed);

/// `families` families of `members` models each, family by family.
std::vector<descriptor::ModelDescriptor> built_collection(std::size_t families,
                                                          std::size_t members);

/// Pointers to all of them.
std::vector<const descriptor::ModelDescriptor*> pointers(
    const std::vector<descriptor::ModelDescriptor>& models);

}  // namespace ossuary::test
