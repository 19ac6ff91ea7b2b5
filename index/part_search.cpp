#include "index/part_search.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "engine/core/parallel.h"
#include "engine/ranking/part_search.h"
#include "index/preview.h"

namespace ossuary::index {

namespace {

constexpr std::size_t kPage = 128;          ///< models whose features are in memory at once
constexpr double kSurelyElsewhere = 0.35;   ///< placed no nearer, a part is not there
constexpr double kSkeletonShare = 0.2;      ///< beside features, of what is not in its place
constexpr std::size_t kPlacedAtOnce = 16;

Error part_cancelled() { return {ErrorCode::kCancelled, "the search was cancelled"}; }

/// Goes through the features of all models, page by page.
template <typename Visit>
Result<void> each_page(Store& store, const std::stop_token& stop, const Visit& visit) {
    ModelId after = 0;
    while (true) {
        if (stop.stop_requested()) return part_cancelled();
        const auto page = store.features(after, kPage);
        if (!page) return page.error();
        if (page->empty()) return {};
        after = page->back().id;
        visit(*page);
    }
}

struct Likeness {
    std::vector<std::size_t> positions;  ///< ascending
    std::vector<double> values;          ///< of each of these
};

Result<Likeness> likeness_of(Store& store, const Snapshot& snapshot,
                             const registration::PieceQuery& piece,
                             const ranking::RankOptions& options) {
    Likeness likeness;
    std::vector<std::vector<std::uint16_t>> nearest;
    const auto gone_through = each_page(store, options.stop, [&](const auto& page) {
        std::vector<const registration::WholeFeatures*> known;
        for (const StoredFeatures& each : page) {
            const auto position = snapshot.find(each.id);
            if (!position) continue;
            likeness.positions.push_back(*position);
            known.push_back(&each.features);
        }
        const std::size_t first = nearest.size();
        nearest.resize(first + known.size());
        parallel_for(known.size(), options.jobs, [&](std::size_t i) {
            if (options.stop.stop_requested()) return;
            nearest[first + i] = registration::nearest_features(piece, *known[i]);
        });
    });
    if (!gone_through) return gone_through.error();
    if (options.stop.stop_requested()) return part_cancelled();
    likeness.values = registration::piece_likeness(nearest);
    return likeness;
}

/// Lays the piece into the models at `positions`.
Result<void> place(Store& store, const Snapshot& snapshot, const registration::PieceQuery& piece,
                   const ranking::RankOptions& options, const std::vector<std::size_t>& positions,
                   std::vector<PartFit>& fits) {
    struct Whole {
        registration::WholeFeatures features;
        mesh::TriangleMesh mesh;
    };
    for (std::size_t begin = 0; begin < positions.size(); begin += kPlacedAtOnce) {
        const std::size_t count = std::min(kPlacedAtOnce, positions.size() - begin);
        std::vector<Whole> wholes(count);
        for (std::size_t i = 0; i < count; ++i) {
            const ModelId id = snapshot.models()[positions[begin + i]].id;
            auto features = store.features(id - 1, 1);
            if (!features) return features.error();
            auto preview = store.preview(id);
            // A model may have gone since the snapshot was made.
            if (!preview || features->empty() || features->front().id != id) continue;
            wholes[i] = {std::move(features->front().features), mesh_of(*preview)};
        }
        parallel_for(count, options.jobs, [&](std::size_t i) {
            if (options.stop.stop_requested() || wholes[i].mesh.empty()) return;
            fits[positions[begin + i]].placement = registration::place_piece(
                piece, wholes[i].features, registration::WholeSurface(wholes[i].mesh));
        });
        if (options.stop.stop_requested()) return part_cancelled();
    }
    return {};
}

/// What lies in its place comes first, by how well; then what is alike.
void fuse(PartFit& fit) {
    const double apart =
        fit.placement ? std::min(1.0, fit.placement->distance / kSurelyElsewhere) : 1.0;
    fit.shares = {{"placement", 0.5 * apart},
                  {"features", 0.5 * apart * (1.0 - kSkeletonShare) * fit.features},
                  {"skeleton", 0.5 * apart * kSkeletonShare * fit.skeleton}};
    fit.distance = 0.0;
    for (const matching::DistancePart& share : fit.shares) fit.distance += share.value;
}

}  // namespace

Result<PartFits> part_fits(Store& store, const Snapshot& snapshot, const PartQuery& query,
                           const ranking::RankOptions& options,
                           const std::vector<std::uint32_t>& among) {
    const auto skeletons =
        ranking::part_distances(query.descriptor, snapshot.descriptors(), options);
    if (!skeletons) return skeletons.error();
    const auto likeness = likeness_of(store, snapshot, query.piece, options);
    if (!likeness) return likeness.error();

    PartFits result;
    result.fits.resize(snapshot.size());
    result.without_features = snapshot.size() - likeness->positions.size();
    for (std::size_t i = 0; i < snapshot.size(); ++i) result.fits[i].skeleton = (*skeletons)[i];
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < likeness->positions.size(); ++i) {
        const std::size_t position = likeness->positions[i];
        result.fits[position].features = 1.0 - likeness->values[i];
        const bool wanted =
            among.empty() || std::binary_search(among.begin(), among.end(), position);
        if (wanted) positions.push_back(position);
    }
    std::stable_sort(positions.begin(), positions.end(), [&](std::size_t a, std::size_t b) {
        return result.fits[a].features < result.fits[b].features;
    });
    if (positions.size() > kPartsPlaced) positions.resize(kPartsPlaced);
    const auto placed = place(store, snapshot, query.piece, options, positions, result.fits);
    if (!placed) return placed.error();
    for (PartFit& fit : result.fits) fuse(fit);
    return result;
}

}  // namespace ossuary::index
