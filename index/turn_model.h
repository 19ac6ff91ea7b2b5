#pragma once

#include <optional>

#include "engine/core/result.h"
#include "index/store.h"
#include "index/thumbnail/thumbnail.h"
#include "index/up.h"

namespace ossuary::index {

/// Thumbnails of models that stand by this axis.
[[nodiscard]] ThumbnailOptions thumbnail_options(Up up);

/// The change that lets an indexed model stand by another axis: its thumbnail, if that is another
/// than before, is drawn anew from its preview.
/// @param up  what a person says; none = as the file says, else to be found again
/// Errors: model_not_found, those of the store and of render_thumbnail.
Result<TurnModel> plan_turn(Store& store, ModelId id, std::optional<Up> up);

/// The same, and does it; returns how the model stands now.
Result<Orientation> turn_model(Store& store, ModelId id, std::optional<Up> up);

}  // namespace ossuary::index
