#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/result.h"
#include "engine/descriptor/model_descriptor.h"
#include "engine/ranking/ranker.h"
#include "engine/ranking/retrieval_metrics.h"
#include "index/model.h"
#include "index/scan_block.h"
#include "index/upload.h"

namespace ossuary::index {

enum class Access {
    kReadOnly,
    kReadWrite,
    kInspect,  ///< the file and its log as they stand: an older index stays at its version, and may
               ///< only be asked for parameters, version and `verify`
};

// The changes that one transaction may hold.
struct PutModel {  ///< adds the model, or replaces the one that has its path
    NewModel model;
};
struct MoveModel {  ///< the file of `id` is now at `path`
    ModelId id = 0;
    std::string path, name;
    std::optional<std::string> class_name;  ///< none = as it was
};
struct ClassifyModel {
    ModelId id = 0;
    std::string class_name;
};
/// Which way a model stands; no new revision, since nothing that is searched changes.
struct TurnModel {
    ModelId id = 0;
    Orientation orientation;
    std::optional<std::vector<std::uint8_t>> thumbnail;  ///< PNG; none = as it was
};
struct RemoveModel {
    ModelId id = 0;
};
struct AddFeatures {  ///< of a model that has none; does nothing if it has changed since
    ModelId id = 0;
    Revision changed_at = 0;
    registration::WholeFeatures features;
};
struct RecordFailure {  ///< replaces an earlier failure and, if its bytes differ, model of the path
    std::string path, content_hash;
    Error error;
};
struct ForgetFailure {
    std::string path;
};
struct PutUpload {  ///< adds the model of an upload, which is then done
    UploadClaim upload;
    NewModel model;
};
struct FailUpload {  ///< the upload has failed for good
    UploadClaim upload;
    Error error;
};
using Change = std::variant<PutModel, MoveModel, ClassifyModel, TurnModel, RemoveModel,
                            RecordFailure, ForgetFailure, PutUpload, FailUpload, AddFeatures>;

/// What is to be done for a file, see Store::claim_work.
struct Work {
    enum class Kind {
        kDescribe,      ///< new, or its bytes changed
        kUnchanged,     ///< `models` holds the model
        kKnownFailure,  ///< the same bytes failed before
        kSameContent,   ///< `models` lists models of other paths with the same bytes
    };
    Kind kind = Kind::kDescribe;
    std::vector<ModelSummary> models;
    std::optional<ModelSummary> earlier;  ///< the model of this path, if its bytes were others
    std::optional<Failure> failure;       ///< the last one of this path, if any
};

/// A page of models in the order of their ids.
struct ModelFilter {
    ModelId after = 0;                      ///< only ids above
    std::size_t limit = 100;                ///< 0 = all
    std::optional<std::string> class_name;  ///< only this class
    std::string name_contains;              ///< part of the name, any case (ASCII)
};
struct ModelPage {
    std::vector<ModelSummary> models;
    std::optional<ModelId> next;  ///< `after` of the next page; none when this is the last
    std::size_t total = 0;        ///< models that pass the filter, on all pages
    Revision revision = 0;
};

struct StoredDescriptor {
    ModelId id = 0;
    Revision changed_at = 0;                 ///< of the model
    descriptor::ModelDescriptor descriptor;  ///< with its derived matching data
};
/// A model as lists and facets know it.
struct ListedModel {
    ModelId id = 0;
    std::string name, class_name, path, indexed_at;  ///< as in ModelSummary
    std::uint32_t faces = 0, branches = 0;
    double longest_side = 0.0;     ///< of its bounds, model units
    double metres_per_unit = 0.0;  ///< 0 where the file names no unit
};
/// How many independent loops a model's skeleton has.
struct ModelLoops {
    ModelId id = 0;
    std::uint32_t loops = 0;
};
/// What pieces of a model are found by, and when the model last changed.
struct StoredFeatures {
    ModelId id = 0;
    Revision changed_at = 0;
    registration::WholeFeatures features;
};
/// The collection's statistics and the revision that they were made at.
struct StoredStatistics {
    ranking::CollectionStatistics statistics;
    Revision revision = 0;
};

/// What a snapshot is up to date with.
struct CollectionState {
    Revision models = 0;
    Revision statistics = -1;  ///< at which statistics were last made; -1 = never
    /// How often another file has taken the index's place since this program opened it: revisions
    /// compare within one file only.
    std::uint64_t replacements = 0;
    bool operator==(const CollectionState&) const = default;
};
/// What searches look at of a whole collection, as of one revision.
struct StoredScan {
    struct Block {
        std::int64_t number = 0;
        std::shared_ptr<const ScanBlock> models;
    };
    CollectionState state;
    bool whole = true;          ///< false: `blocks` has only what has changed since what was known
    std::vector<Block> blocks;  ///< ascending
    /// None if there are none, or if they are the known ones.
    std::optional<StoredStatistics> statistics;
    /// Paths that have the same folders in common as those of all models: of each folder at the
    /// top of the machine that models lie below, the first and the last of them.
    std::vector<std::string> outer_paths;
};

/// Names one cached evaluation.
struct EvaluationKey {
    Revision revision = 0;
    ranking::RankerKind ranker = ranking::RankerKind::kHybrid;
    bool rerank = false;
    double pose = 0.0;
    std::string collection_hash;     ///< of the evaluated ids and their classes, 32 hex digits
    std::uint64_t replacements = 0;  ///< see CollectionState; none is kept for a file that is gone
};
struct StoredEvaluation {
    EvaluationKey key;
    ranking::RetrievalReport report;
    std::string computed_at;  ///< ISO 8601, UTC
};

/// Something that Store::verify found wrong.
struct Finding {
    std::string subject;  ///< e.g. "model 7, skeleton"
    std::string message;
};
struct VerifyReport {
    std::size_t models = 0;
    std::size_t blobs = 0;  ///< decoded
    std::size_t failures = 0;
    std::size_t uploads = 0;  ///< finished ones too
    int version = 0;          ///< of the schema
    Revision revision = 0;
    std::vector<Finding> findings;  ///< empty for a sound index
};

/// Whether an error says that the file cannot serve as the index that was asked for (absent,
/// foreign, newer, damaged, other parameters): exit status 4 of both programs.
[[nodiscard]] bool is_unusable_index(ErrorCode code);

/// One index on disk (docs/index-format.md). The only file of the program that knows SQL; a store
/// for several machines would offer the same calls. Safe to call from several threads, which then
/// take turns; other processes may read and write the same index meanwhile.
///
/// Errors of every call: index_busy when another process holds the write lock for too long,
/// index_io for a full disk and the like, index_corrupt for damaged contents, model_not_found for
/// an id that is not there, index_replaced when another file has taken the index's place.
class Store {
public:
    /// Opens an index. Nothing is ever written to a file that is not an index. An index of an
    /// older version is first migrated, in one transaction a version, unless only to be inspected.
    /// Errors: index_not_found, index_foreign (not an index), index_newer, index_io …
    static Result<Store> open(const std::filesystem::path& path, Access access);
    /// The same for writing; makes the index if there is no file, or an empty one.
    /// Errors: also index_parameters when the index was built with other parameters.
    static Result<Store> create_or_open(const std::filesystem::path& path,
                                        const IndexParameters& parameters);
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;
    ~Store();

    [[nodiscard]] const std::filesystem::path& path() const;
    /// Whether `file` is the index itself or one that SQLite keeps beside it, by whatever name.
    /// Such a file must not be opened by anything but the store while the index is open: closing it
    /// would take the store's locks away.
    [[nodiscard]] bool owns(const std::filesystem::path& file) const;
    [[nodiscard]] const IndexParameters& parameters() const;
    /// The schema's version, after any migration.
    [[nodiscard]] int version() const;
    /// From now on, when another file takes the place of the index, calls are answered from that
    /// one, if it has the same parameters; otherwise they give index_replaced from then on.
    /// Nothing is written to a file that has lost its place, nor acknowledged if it was.
    void follow_replacements();
    [[nodiscard]] bool follows_replacements() const;
    Result<Revision> revision();
    /// Cheap: what a reader asks to learn whether it is up to date.
    Result<CollectionState> collection_state();

    // Writing. All changes of one call are one transaction and one revision, or nothing happens.

    /// The model's id for each change, in order; 0 for those that concern no model.
    Result<std::vector<ModelId>> apply(std::span<const Change> changes);
    Result<ModelId> put(NewModel model);
    Result<void> remove(ModelId id);

    // Uploads wait in the index until a program has described them.

    /// Accepts an upload; none when too many wait. Once this returns it is on the disk, whatever
    /// becomes of the program or the machine.
    Result<std::optional<UploadId>> add_upload(const UploadedModel& upload,
                                               const UploadLimits& limits);
    /// The longest waiting upload, which is then the claimant's (see process_mark) until it is
    /// finished by a PutUpload or FailUpload, or released, or the claimant's process ends. Asked
    /// again, a claimant gets the one that it has. None when nothing waits.
    Result<std::optional<ClaimedUpload>> claim_upload(std::string_view claimant);
    /// Back to its place in the queue, as if it had not been claimed.
    Result<void> release_upload(const UploadClaim& claim);
    /// None for a number that was never given, or is not remembered any more.
    Result<std::optional<UploadRecord>> upload(UploadId id);
    /// The last ones that were accepted, the newest first, whichever program works on them.
    Result<std::vector<UploadRecord>> uploads(std::size_t most);
    Result<UploadQueue> upload_queue();

    // Work for the indexer. The claim is not exclusive: should two processes describe the same
    // file, the second finds it done when it comes to write.

    Result<Work> claim_work(std::string_view path, std::string_view content_hash);

    // Reading.

    Result<ModelPage> models(const ModelFilter& filter = {});
    Result<ModelSummary> model(ModelId id);
    /// Models by name (exact), in the order of their ids.
    Result<std::vector<ModelSummary>> models_named(std::string_view name);
    /// What searches look at; of what a reader has that knows `known`, only what has changed. What
    /// is known of an earlier file counts for nothing.
    Result<StoredScan> scan(const std::optional<CollectionState>& known = {});
    /// Descriptors of `ids`, in their order; ids that are gone are left out. Decoded by `jobs`
    /// threads, one after the other in their order.
    Result<std::vector<StoredDescriptor>> descriptors(std::span<const ModelId> ids, int jobs = 1);
    /// The models with ids from `first` to `last`, in their order.
    Result<std::vector<ListedModel>> listed(ModelId first, ModelId last);
    /// Likewise; looks at all their branches: some microseconds a model.
    Result<std::vector<ModelLoops>> loops(ModelId first, ModelId last);
    Result<StoredSkeleton> skeleton(ModelId id);
    Result<PreviewMesh> preview(ModelId id);
    /// None for a model that could not be cut into parts.
    Result<std::optional<ModelSegments>> segments(ModelId id);
    /// Local features of the surfaces of at most `limit` models with ids above `after`, in the
    /// order of ids; models that have none are left out. Decoded by `jobs` threads.
    Result<std::vector<StoredFeatures>> features(ModelId after, std::size_t limit, int jobs = 1);
    /// At most `limit` models with ids above `after` that have none, in the order of ids;
    /// `features` is empty.
    Result<std::vector<StoredFeatures>> without_features(ModelId after, std::size_t limit);
    Result<std::vector<std::uint8_t>> thumbnail(ModelId id);
    Result<std::vector<Failure>> failures();

    // What is computed over the whole collection.

    Result<std::optional<StoredStatistics>> statistics();
    /// With `replacements`, only into the file that they were made from.
    Result<void> put_statistics(const ranking::CollectionStatistics& statistics, Revision revision,
                                std::optional<std::uint64_t> replacements = {});
    Result<std::optional<StoredEvaluation>> evaluation(const EvaluationKey& key);
    /// Those of the current revision, newest first.
    Result<std::vector<StoredEvaluation>> evaluations();
    /// Keeps the evaluation and drops those of earlier revisions.
    Result<void> put_evaluation(const EvaluationKey& key, const ranking::RetrievalReport& report);

    /// Reads everything: SQLite's own checks, every blob, indices, hashes, cross references.
    Result<VerifyReport> verify();
    /// How long a write waits for another process's; ten seconds unless set.
    Result<void> set_busy_timeout(int milliseconds);
    /// Writes the log back into the file, so that the file alone is the whole index; as far as
    /// other programs let it, and without waiting for them.
    Result<void> checkpoint();

    struct Impl;  ///< the store's own

private:
    explicit Store(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace ossuary::index
