#include "index/turn_model.h"

#include "index/preview.h"
#include "index/upright.h"

namespace ossuary::index {

ThumbnailOptions thumbnail_options(Up up) {
    ThumbnailOptions options;
    options.up = up_direction(up);
    options.towards_viewer = viewer_direction(up);
    return options;
}

Result<TurnModel> plan_turn(Store& store, ModelId id, std::optional<Up> up) {
    const auto model = store.model(id);
    if (!model) return model.error();
    const auto preview = store.preview(id);
    if (!preview) return preview.error();
    const mesh::TriangleMesh mesh = mesh_of(*preview);
    const Up found = model->frame.up ? *model->frame.up : find_up(mesh);
    TurnModel turn{id, {up ? *up : found, up.has_value()}, {}};
    if (turn.orientation.up == model->orientation.up) return turn;
    auto thumbnail = render_thumbnail(mesh, thumbnail_options(turn.orientation.up));
    if (thumbnail) {
        turn.thumbnail = *std::move(thumbnail);
    } else if (thumbnail.error().code != ErrorCode::kMeshEmpty &&
               thumbnail.error().code != ErrorCode::kMeshNoExtent) {
        return thumbnail.error();
    }
    return turn;
}

Result<Orientation> turn_model(Store& store, ModelId id, std::optional<Up> up) {
    auto turn = plan_turn(store, id, up);
    if (!turn) return turn.error();
    const Orientation orientation = turn->orientation;
    const Change change = *std::move(turn);
    if (const auto applied = store.apply({&change, 1}); !applied) return applied.error();
    return orientation;
}

}  // namespace ossuary::index
