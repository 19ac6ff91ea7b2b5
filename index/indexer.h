#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/ranking/classification.h"
#include "index/model.h"
#include "index/model_files.h"
#include "index/model_reader.h"
#include "index/prune.h"
#include "index/snapshot.h"
#include "index/store.h"
#include "index/upload.h"

namespace ossuary::index {

/// Whether models under the paths of a run are removed whose files are gone or passed over.
enum class Prune {
    kNo,
    kYes,    ///< but see plan_prune for places that may only be out of reach
    kForce,  ///< those too
};

struct IndexOptions {
    /// Files (any) and folders (walked for model files, see find_model_files). Each must exist, but
    /// for one that the index has models of where pruning is asked for.
    std::vector<std::filesystem::path> paths;
    WalkOptions walk;
    std::optional<ranking::Classification>
        classes;   ///< names the models' classes; id N is N.off or mN.off
    int jobs = 0;  ///< models described at once; 0 = hardware threads
    Prune prune = Prune::kNo;
    /// The axis that points up in all models under `paths`, also in those already indexed; none =
    /// found for each new one, and others stay as they are.
    std::optional<Up> up;
    /// Reads the files; null = formats that are read within the program alone.
    ModelReader* reader = nullptr;
    /// What is inside volumes; none = found (voxel::volume_surface). Volumes that were indexed with
    /// another answer are described anew.
    voxel::InsideOptions inside;
    /// Each object of a file that tells several apart is a model of its own, placed as in the file.
    bool split = false;
    bool retry_failed = false;  ///< try again what failed before, though its bytes are the same
    /// A model that takes longer is recorded as `cancelled` (seen between the stages of its
    /// description), or indexed without parts if only those were missing; 0 = for ever.
    double model_timeout_seconds = 600.0;
    std::size_t batch_models = 8;  ///< changes a transaction; fixed, so that revisions do
                                   ///< not depend on time
};

/// How far indexing has come.
struct IndexProgress {
    std::size_t done = 0;
    std::size_t total = 0;
    std::size_t indexed = 0;
    std::size_t unchanged = 0;
    std::size_t failed = 0;
    double models_per_second = 0.0;  ///< of models described, not of those skipped
    double eta_seconds = 0.0;
    std::string path;  ///< of the model done last
};

/// Hears what the indexer does; called from one thread at a time.
class ProgressSink {
public:
    virtual ~ProgressSink() = default;
    /// What there is to index, before the first model.
    virtual void found(const FoundFiles&) {}
    virtual void progress(const IndexProgress&) {}
    virtual void failed(const Failure&) {}
    /// What goes on besides single models: "computing statistics of 380 models"
    virtual void phase(std::string_view) {}
};

struct IndexOutcome {
    std::size_t files = 0;           ///< found under `paths`
    std::size_t indexed = 0;         ///< described now
    std::size_t moved = 0;           ///< same bytes, new path, old file gone
    std::size_t unchanged = 0;       ///< skipped, already in the index
    std::size_t failed = 0;          ///< failed now
    std::size_t known_failures = 0;  ///< skipped, failed before with the same bytes
    std::size_t classified = 0;      ///< unchanged models whose class changed
    std::size_t turned = 0;          ///< models already indexed that got the axis that was named
    std::size_t pruned = 0;
    PassedOver passed_over;
    std::vector<UnreadableFolder> unreadable;
    std::vector<PruneRefusal> refusals;  ///< what was not pruned, though asked for
    Revision revision = 0;
    double seconds = 0.0;
};

/// Brings the index up to date with the files under `options.paths`. A model that fails is recorded
/// and the rest goes on. The outcome in the index is the same for every number of jobs, and after a
/// kill the next run goes on where the last one's final transaction ended.
/// Errors: file_not_found for a path that does not exist (before anything is done), those of the
/// store, cancelled when `stop` was requested (what is done by then stays).
Result<IndexOutcome> index_models(Store& store, const IndexOptions& options, ProgressSink& sink,
                                  std::stop_token stop = {});

/// All that an index keeps of an uploaded model, for PutUpload.
/// @param reader  reads it; null = formats that are read within the program alone
/// Errors: those of describe_model; cancelled when `stop` was requested before its skeleton was
/// there, later the model comes without parts.
Result<NewModel> describe_upload(const UploadedModel& upload, const IndexParameters& parameters,
                                 std::stop_token stop = {}, ModelReader* reader = nullptr);

/// Recomputes the collection's statistics if they are not those of the current revision.
/// Errors: cancelled, those of the store, index_busy when models change while they are measured.
Result<void> update_statistics(Store& store, int jobs = 1, const std::stop_token& stop = {});

/// The same for a snapshot of the store that is in memory already.
Result<void> update_statistics(Store& store, const Snapshot& snapshot, int jobs = 1,
                               const std::stop_token& stop = {});

}  // namespace ossuary::index
