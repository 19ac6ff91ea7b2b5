#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/stage_report.h"
#include "engine/core/stopwatch.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/matching/match.h"
#include "engine/mesh/body.h"
#include "engine/mesh/triangle_mesh.h"
#include "engine/ranking/descriptor_source.h"
#include "engine/ranking/ranker.h"
#include "engine/registration/piece_search.h"
#include "index/model.h"
#include "index/snapshot.h"
#include "index/store.h"
#include "index/store_pool.h"

namespace ossuary::index {

struct SearchOptions {
    ranking::RankOptions rank;
    std::size_t limit = 10;                   ///< hits returned; 0 = all
    std::string class_filter;                 ///< only hits of this class; empty = all
    std::optional<std::string> folder, kind;  ///< as those of CatalogueFilter
    bool with_match = true;                   ///< parts and correspondences of the returned hits
    bool fold_copies = false;  ///< of models that are copies of each other, the nearest alone
    StageReport on_stage = {};
};

struct Hit {
    std::size_t rank = 0;  ///< from 1
    ModelId id = 0;
    std::string name;
    std::string class_name;
    std::string path;         ///< absolute; empty for a model that was uploaded
    std::uint32_t faces = 0;  ///< polygons in the file
    Vec3 extent;              ///< of its bounds, model units
    std::size_t copies = 0;   ///< how many models of the collection are copies of it (Snapshot)
    double distance = 0.0;
    std::vector<matching::DistancePart> parts;
    std::size_t matched_nodes = 0;
    std::optional<double> build, pose;  ///< those of matching::Match
    /// Where a part lies in the hit, both in model units; only with `part`, and of the most alike.
    std::optional<registration::PiecePlacement> placement;
    matching::Correspondence match;  ///< a = the query's nodes and branches, b = the hit's
};

struct SearchResult {
    double took_ms = 0.0;
    StageTimes stages_ms;
    StoredSkeleton query_skeleton;  ///< model units
    mesh::Body query_body;          ///< what of the mesh was looked for; of an indexed model, empty
    std::vector<mesh::MeshWarning> warnings;
    std::vector<Hit> hits;   ///< nearest first; equal distances in the order of ids
    std::size_t models = 0;  ///< compared with
    Revision revision = 0;
};

/// A mesh as it is looked for, described once however often it is ranked. Model units.
struct DescribedQuery {
    descriptor::ModelDescriptor descriptor;
    StoredSkeleton skeleton;
    mesh::Body body;  ///< what of the mesh was described
    std::vector<mesh::MeshWarning> warnings;
    StageTimes stages_ms;  ///< of describing it
};

/// One side of a comparison.
struct ComparedModel {
    ModelSummary summary;  ///< id 0 and only the name for a model that is not in an index
    StoredSkeleton skeleton;
};
struct Comparison {
    ComparedModel a;
    ComparedModel b;
    matching::Match match;
};

/// Compares two meshes without an index. Distances of `hybrid` are then not normalised by any
/// collection.
Result<Comparison> compare_meshes(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                                  const IndexParameters& parameters = {},
                                  const ranking::RankOptions& options = {},
                                  std::stop_token stop = {});

/// Answers queries over an index. Safe to call from several threads at once.
class Searcher {
public:
    /// Errors: those of Store::open, index_parameters when the index was built by another version
    /// of the pipeline.
    static Result<Searcher> open(const std::filesystem::path& path,
                                 Access access = Access::kReadOnly);
    Searcher(Searcher&&) noexcept;
    Searcher& operator=(Searcher&&) noexcept;
    ~Searcher();

    /// The index at its current revision: what was loaded before if nothing has changed.
    Result<std::shared_ptr<const Snapshot>> snapshot();
    /// For whatever is not in the snapshot: pages, previews, thumbnails.
    [[nodiscard]] Store& store();
    /// The same for many readers at once.
    [[nodiscard]] StorePool& stores();

    /// As the models of the index were described. Errors: those of descriptor::describe.
    Result<DescribedQuery> describe(const mesh::TriangleMesh& query, std::stop_token stop = {},
                                    const StageReport& on_stage = {});
    /// The models nearest to a query; its warnings, skeleton and body are left out of the result.
    /// @param piece  the query's surface, for a search by part; without, that goes by the skeleton
    /// alone
    /// Errors: cancelled.
    Result<SearchResult> nearest(const DescribedQuery& query, const SearchOptions& options = {},
                                 std::stop_token stop = {},
                                 const registration::PieceQuery* piece = nullptr);
    /// Both at once. Errors: those of describe, cancelled.
    Result<SearchResult> search(const mesh::TriangleMesh& query, const SearchOptions& options = {},
                                std::stop_token stop = {});
    /// The models nearest to an indexed one, itself left out. Errors: model_not_found, cancelled.
    Result<SearchResult> similar(ModelId id, const SearchOptions& options = {},
                                 std::stop_token stop = {});
    /// Errors: model_not_found, cancelled.
    Result<Comparison> compare(ModelId a, ModelId b, const ranking::RankOptions& options = {},
                               std::stop_token stop = {});

private:
    struct Impl;
    struct Consistent {
        std::shared_ptr<const Snapshot> snapshot;
        std::vector<ranking::SharedDescriptor> descriptors;
        std::vector<StoredSkeleton> skeletons;
    };
    /// A snapshot together with descriptors and skeletons of some of its models. Errors:
    /// model_not_found.
    Result<Consistent> consistent(const std::vector<ModelId>& ids);

    explicit Searcher(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace ossuary::index
