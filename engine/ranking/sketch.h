#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptor/model_descriptor.h"
#include "engine/ranking/pair_distances.h"

namespace ossuary::ranking {

/// Bytes of a sketch: a seventh of the global descriptors that it stands for.
inline constexpr std::size_t kSketchSize = 1017;
using Sketch = std::array<std::uint8_t, kSketchSize>;

/// The global descriptors of a model in few bytes, to be compared by themselves: histograms with
/// fewer bins, of views the low frequencies, the size as it is. What a model has no descriptor for
/// is 0. Half of the bytes are of views: of the ten nearest of 682 models (every model of one
/// benchmark collection and every third of another) .9946 are among the hundred nearest by
/// sketches, .9988 among 150, .9994 among 200; by the whole descriptors .9985, .9993 and .9996.
/// With views of a quarter, half and one and a half times the bytes .9906, .9931 and .9963 are
/// among the hundred; with all the other histograms whole nothing is gained.
[[nodiscard]] Sketch sketch_of(const std::vector<descriptor::GlobalDescriptor>& globals);

/// About PairMeter::cheap_components of the two models, each in its own unit.
/// @pre kSketchSize bytes each
[[nodiscard]] ComponentValues sketch_components(std::span<const std::uint8_t> a,
                                                std::span<const std::uint8_t> b,
                                                const RankOptions& options);

}  // namespace ossuary::ranking
