#include "index/indexer.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/core/parallel.h"
#include "engine/core/stopwatch.h"
#include "engine/core/text.h"
#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "index/describe_model.h"
#include "index/descriptor_cache.h"
#include "index/file_stamp.h"
#include "index/missing_features.h"
#include "index/model_files.h"
#include "index/model_place.h"
#include "index/model_timer.h"
#include "index/open_files.h"
#include "index/ordered_pipeline.h"
#include "index/snapshot.h"
#include "index/timestamp.h"
#include "index/turn_model.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

/// How many descriptions may wait for the writer, besides one a worker: enough that a slow model
/// does not hold up the others, little enough to fit (some 100 KB each).
constexpr std::size_t kWindow = 64;

/// What a worker found out about one file.
struct FileOutcome {
    enum class Kind { kDescribed, kUnchanged, kMoved, kKnownFailure, kFailed, kBroken, kCancelled };
    Kind kind = Kind::kCancelled;
    std::string content_hash;
    NewModel model;                    ///< described
    std::vector<ModelSummary> models;  ///< unchanged: the model; moved: those with the same bytes
    std::optional<TurnModel> turn;     ///< unchanged: what makes it stand as was asked for
    bool had_failed = false;           ///< unchanged: could not be read at some time since
    Error error;                       ///< failed: of the file; broken: of the index
};

/// One run of index_models: `process` on the workers, the rest on the caller's thread.
class IndexRun {
public:
    IndexRun(Store& store, const IndexOptions& options, ProgressSink& sink, std::stop_token stop)
        : store_(store),
          options_(options),
          sink_(sink),
          stop_(std::move(stop)),
          timer_(options.model_timeout_seconds) {}

    Result<IndexOutcome> run();

private:
    FileOutcome process(const fs::path& path);
    FileOutcome look_at(const fs::path& path);
    [[nodiscard]] ModelSource source_of(const ModelBytes& file, std::optional<Up> up) const;
    FileOutcome describe_file(const fs::path& path, const ModelBytes& file, const std::string& hash,
                              std::optional<Up> up);
    Result<ModelBytes> open(const fs::path& path);
    bool consume(const fs::path& path, FileOutcome outcome);
    void put(const fs::path& path, NewModel model);
    void fail(const fs::path& path, const std::string& hash, const Error& error);
    void keep(const ModelSummary& model, const fs::path& path);
    void move(const fs::path& path, FileOutcome outcome);
    void turn(const ModelSummary& model, FileOutcome& outcome);
    void take_turn(std::optional<TurnModel> turn);
    bool change(Change change);
    bool flush();
    void report(const fs::path& path);
    Result<void> find_files();
    Result<std::vector<ModelSummary>> all_models();
    Result<void> prune();

    [[nodiscard]] std::optional<std::string> class_of(const fs::path& path) const {
        const auto found = classes_.find(place_of(path).file_name().string());
        if (found == classes_.end()) return {};
        return found->second;
    }

    Store& store_;
    const IndexOptions& options_;
    ProgressSink& sink_;
    std::stop_token stop_;
    ModelTimer timer_;
    std::vector<fs::path> roots_;
    FoundFiles found_;
    /// As they were when they were asked what is in them.
    std::map<std::string, std::optional<FileStamp>> listed_;
    std::vector<std::string> paths_before_;  ///< of all models, where pruning asks for them
    std::map<std::string, std::string> classes_;
    std::vector<Change> pending_;
    std::set<ModelId> moved_;  ///< in this run, so that one model moves once
    std::optional<Error> error_;
    IndexOutcome outcome_;
    IndexProgress progress_;
    Stopwatch since_start_;
    std::optional<Stopwatch> since_work_;  ///< since the first file that was not just skipped
    std::size_t skipped_before_work_ = 0;
};

Error changed_meanwhile(const fs::path& path) {
    return {ErrorCode::kFileUnreadable,
            path.string() +
                ": expected a file that stays as it is while it is indexed, found it "
                "written to; the next run takes it as it is then"};
}

FileOutcome IndexRun::process(const fs::path& path) {
    if (stop_.stop_requested()) return {};
    const fs::path file = place_of(path).file;
    const auto listed = listed_.find(file.native());
    const auto before = listed == listed_.end() ? stamp_of(file) : listed->second;
    FileOutcome outcome = look_at(path);
    const bool was_used =
        outcome.kind == FileOutcome::Kind::kDescribed || outcome.kind == FileOutcome::Kind::kFailed;
    if (was_used && stamp_of(file) != before) {
        outcome = {};
        outcome.kind = FileOutcome::Kind::kFailed;
        outcome.error = changed_meanwhile(path);
    }
    return outcome;
}

FileOutcome IndexRun::look_at(const fs::path& path) {
    FileOutcome outcome;
    if (store_.owns(path)) {
        outcome.kind = FileOutcome::Kind::kFailed;
        outcome.error = {ErrorCode::kFormatUnknown, path.string() + ": is the index itself"};
        return outcome;
    }
    const auto file = open(path);
    if (!file) {
        outcome.kind = FileOutcome::Kind::kFailed;
        outcome.error = file.error();
        return outcome;
    }
    outcome.content_hash = model_hash(source_of(*file, {}));
    auto work = store_.claim_work(path.string(), outcome.content_hash);
    if (!work) {
        outcome.kind = FileOutcome::Kind::kBroken;
        outcome.error = work.error();
        return outcome;
    }
    const bool same_content = work->kind == Work::Kind::kSameContent;
    if (work->kind == Work::Kind::kUnchanged) {
        outcome.kind = FileOutcome::Kind::kUnchanged;
        outcome.had_failed = work->failure.has_value();
        turn(work->models.front(), outcome);
    } else if (work->kind == Work::Kind::kKnownFailure && !options_.retry_failed) {
        outcome.kind = FileOutcome::Kind::kKnownFailure;
    } else if (same_content &&
               std::any_of(work->models.begin(), work->models.end(), [](const ModelSummary& model) {
                   return !model.path.empty() && is_gone(model.path);
               })) {
        outcome.kind = FileOutcome::Kind::kMoved;
    } else {
        const bool was_told = work->earlier && work->earlier->orientation.said_by_person;
        return describe_file(
            path, *file, outcome.content_hash,
            was_told && !options_.up ? std::optional(work->earlier->orientation.up) : options_.up);
    }
    outcome.models = std::move(work->models);
    return outcome;
}

/// Adds what makes an indexed model stand as was asked for, if it does not.
void IndexRun::turn(const ModelSummary& model, FileOutcome& outcome) {
    if (!options_.up || model.orientation == Orientation{*options_.up, true}) return;
    auto planned = plan_turn(store_, model.id, options_.up);
    if (planned) {
        outcome.turn = *std::move(planned);
    } else {
        outcome.kind = FileOutcome::Kind::kBroken;
        outcome.error = planned.error();
    }
}

/// Within the program's limits; archives and files beside a model need a reader.
Result<ModelBytes> IndexRun::open(const fs::path& path) {
    const std::uint64_t most = mesh::ReadMeshOptions{}.max_bytes;
    if (options_.reader != nullptr) return options_.reader->open(path, most, stop_);
    auto bytes = read_whole_file(path, most);
    if (!bytes) return bytes.error();
    return ModelBytes{*std::move(bytes), path.string(), {}, {}};
}

ModelSource IndexRun::source_of(const ModelBytes& file, std::optional<Up> up) const {
    return {file.bytes.view(), file.name,      up, options_.reader, file.companions,
            file.object,       options_.inside};
}

/// @param hash  model_hash before anything of the file was used
FileOutcome IndexRun::describe_file(const fs::path& path, const ModelBytes& file,
                                    const std::string& hash, std::optional<Up> up) {
    FileOutcome outcome;
    outcome.content_hash = hash;
    const ModelTimer::Watch watch(timer_, stop_);
    const ModelSource source = source_of(file, up);
    auto model = describe_model(source, store_.parameters(), watch.token());
    // With files that were written meanwhile it would be half of one state and half of the other.
    if (model ? model->summary.content_hash != hash : model_hash(source) != hash) {
        outcome.kind = FileOutcome::Kind::kFailed;
        outcome.content_hash.clear();
        outcome.error = changed_meanwhile(path);
        return outcome;
    }
    // An interrupted run leaves no model behind that is short of its parts.
    if (stop_.stop_requested() && (!model || !model->segments)) return outcome;
    if (model) {
        outcome.kind = FileOutcome::Kind::kDescribed;
        outcome.model = *std::move(model);
        return outcome;
    }
    outcome.kind = FileOutcome::Kind::kFailed;
    outcome.error = model.error();
    if (outcome.error.code == ErrorCode::kCancelled) {
        outcome.error.message = path.string() + ": took longer than " +
                                std::to_string(options_.model_timeout_seconds) + " s";
    }
    return outcome;
}

bool IndexRun::consume(const fs::path& path, FileOutcome outcome) {
    using Kind = FileOutcome::Kind;
    if (outcome.kind == Kind::kCancelled) return false;
    if (outcome.kind == Kind::kBroken) {
        error_ = std::move(outcome.error);
        return false;
    }
    const bool skipped = outcome.kind == Kind::kUnchanged || outcome.kind == Kind::kKnownFailure;
    if (!skipped && !since_work_) {
        since_work_.emplace();
        skipped_before_work_ = progress_.done;
    }
    switch (outcome.kind) {
        case Kind::kDescribed:
            put(path, std::move(outcome.model));
            break;
        case Kind::kUnchanged:
            keep(outcome.models.front(), path);
            take_turn(std::move(outcome.turn));
            if (outcome.had_failed) change(ForgetFailure{path.string()});
            break;
        case Kind::kMoved:
            move(path, std::move(outcome));
            break;
        case Kind::kKnownFailure:
            ++outcome_.known_failures;
            break;
        default:
            fail(path, outcome.content_hash, outcome.error);
            break;
    }
    report(path);
    return !error_;
}

void IndexRun::put(const fs::path& path, NewModel model) {
    model.summary.path = path.string();
    model.summary.name = place_of(path).name();
    model.summary.class_name = class_of(path).value_or("");
    ++outcome_.indexed;
    change(PutModel{std::move(model)});
}

void IndexRun::fail(const fs::path& path, const std::string& hash, const Error& error) {
    ++outcome_.failed;
    sink_.failed(
        {path.string(), hash, std::string(to_string(error.code)), error.message, utc_now()});
    change(RecordFailure{path.string(), hash, error});
}

void IndexRun::keep(const ModelSummary& model, const fs::path& path) {
    ++outcome_.unchanged;
    const auto class_name = class_of(path);
    if (class_name && *class_name != model.class_name) {
        ++outcome_.classified;
        change(ClassifyModel{model.id, *class_name});
    }
}

void IndexRun::move(const fs::path& path, FileOutcome outcome) {
    for (const ModelSummary& model : outcome.models) {
        if (model.path.empty() || !is_gone(model.path) || moved_.contains(model.id)) continue;
        moved_.insert(model.id);
        ++outcome_.moved;
        FileOutcome turned;
        turn(model, turned);
        if (turned.kind == FileOutcome::Kind::kBroken) {
            error_ = std::move(turned.error);
            return;
        }
        change(MoveModel{model.id, path.string(), place_of(path).name(), class_of(path)});
        take_turn(std::move(turned.turn));
        return;
    }
    // Another path of this run has taken the model's place.
    const auto file = open(path);
    if (!file) return fail(path, "", file.error());
    FileOutcome described =
        describe_file(path, *file, model_hash(source_of(*file, {})), options_.up);
    if (described.kind == FileOutcome::Kind::kDescribed) {
        put(path, std::move(described.model));
    } else if (described.kind == FileOutcome::Kind::kFailed) {
        fail(path, described.content_hash, described.error);
    }
}

void IndexRun::take_turn(std::optional<TurnModel> turn) {
    if (!turn) return;
    ++outcome_.turned;
    change(*std::move(turn));
}

bool IndexRun::change(Change change) {
    pending_.push_back(std::move(change));
    return pending_.size() < std::max<std::size_t>(options_.batch_models, 1) || flush();
}

bool IndexRun::flush() {
    if (pending_.empty() || error_) return !error_;
    const auto applied = store_.apply(pending_);
    if (!applied) error_ = applied.error();
    pending_.clear();
    return !error_;
}

void IndexRun::report(const fs::path& path) {
    ++progress_.done;
    progress_.indexed = outcome_.indexed + outcome_.moved;
    progress_.unchanged = outcome_.unchanged + outcome_.known_failures;
    progress_.failed = outcome_.failed;
    progress_.path = path.string();
    if (since_work_) {
        const double seconds = std::max(since_work_->elapsed_ms() / 1000.0, 1e-3);
        const auto done = static_cast<double>(progress_.done - skipped_before_work_);
        progress_.models_per_second =
            static_cast<double>(outcome_.indexed + outcome_.failed) / seconds;
        progress_.eta_seconds =
            static_cast<double>(progress_.total - progress_.done) * seconds / done;
    }
    sink_.progress(progress_);
}

Result<std::vector<ModelSummary>> IndexRun::all_models() {
    auto page = store_.models({.after = 0, .limit = 0, .class_name = {}, .name_contains = {}});
    if (!page) return page.error();
    return std::move(page->models);
}

Result<void> IndexRun::find_files() {
    for (const fs::path& path : options_.paths) roots_.push_back(index_path(path));
    if (options_.prune != Prune::kNo) {
        const auto models = all_models();
        if (!models) return models.error();
        for (const ModelSummary& model : *models) paths_before_.push_back(model.path);
    }
    auto found = find_model_files(options_.paths, options_.walk, stop_);
    if (!found) return found.error();
    found_ = *std::move(found);
    if (options_.reader != nullptr) {
        for (const fs::path& file : found_.files) {
            if (options_.split || is_archive_name(file)) listed_[file.native()] = stamp_of(file);
        }
        auto opened = open_archives(found_, roots_, options_.walk, *options_.reader, stop_);
        if (opened && options_.split) {
            sink_.phase("looking for objects in " + std::to_string(found_.files.size()) + " files");
            opened = split_files(found_, *options_.reader, options_.jobs, stop_);
        }
        if (!opened) return opened.error();
    }
    for (const fs::path& root : found_.missing) {
        const bool is_known =
            std::any_of(paths_before_.begin(), paths_before_.end(), [&](const std::string& path) {
                return !path.empty() && is_under(place_of(path).file, {root});
            });
        if (!is_known) {
            return {ErrorCode::kFileNotFound, root.string() + ": no such file or folder"};
        }
    }
    outcome_.files = progress_.total = found_.files.size();
    outcome_.passed_over = found_.passed_over;
    outcome_.unreadable = found_.unreadable;
    sink_.found(found_);
    return {};
}

Result<void> IndexRun::prune() {
    const auto models = all_models();
    if (!models) return models.error();
    const auto failures = store_.failures();
    if (!failures) return failures.error();
    PrunePlan plan = plan_prune({paths_before_, *models, *failures}, roots_, found_, options_.walk,
                                options_.prune == Prune::kForce);
    for (const ModelId id : plan.models) change(RemoveModel{id});
    for (std::string& path : plan.failures) change(ForgetFailure{std::move(path)});
    outcome_.pruned = plan.models.size();
    outcome_.refusals = std::move(plan.refusals);
    if (!flush()) return *error_;
    return {};
}

Result<IndexOutcome> IndexRun::run() {
    if (store_.parameters().pipeline != kPipelineVersion) {
        return {ErrorCode::kIndexParameters, store_.path().string() + ": was built by version " +
                                                 std::to_string(store_.parameters().pipeline) +
                                                 " of the pipeline, this program is version " +
                                                 std::to_string(kPipelineVersion) +
                                                 "; index into a new file"};
    }
    if (const auto found = find_files(); !found) return found.error();
    const std::vector<fs::path>& files = found_.files;
    if (options_.classes) classes_ = classes_by_file_name(*options_.classes, files);
    sink_.phase("indexing " + std::to_string(files.size()) + " files");

    run_in_order<FileOutcome>(
        files.size(), resolve_jobs(options_.jobs), kWindow,
        [&](std::size_t i) { return process(files[i]); },
        [&](std::size_t i, FileOutcome outcome) { return consume(files[i], std::move(outcome)); });
    if (!flush()) return *error_;
    if (stop_.stop_requested()) {
        return {ErrorCode::kCancelled,
                "indexing was stopped after " + std::to_string(progress_.done) + " of " +
                    std::to_string(progress_.total) + " files; what is done is kept"};
    }
    if (options_.prune != Prune::kNo) {
        if (const auto pruned = prune(); !pruned) return pruned.error();
    }
    if (const auto added = add_missing_features(store_, options_.jobs, sink_, stop_); !added) {
        return added.error();
    }
    sink_.phase("computing the collection's statistics");
    if (const auto updated = update_statistics(store_, options_.jobs, stop_); !updated) {
        return updated.error();
    }
    const auto revision = store_.revision();
    if (!revision) return revision.error();
    outcome_.revision = *revision;
    outcome_.seconds = since_start_.elapsed_ms() / 1000.0;
    return outcome_;
}

/// What may stand as an upload's name: UTF-8 without control characters, no more than a line.
std::string clean_name(std::string_view name) {
    constexpr std::size_t kLongest = 200;  // bytes
    std::string clean = valid_utf8(name);
    std::erase_if(clean, [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; });
    clean.resize(cut_utf8(clean, kLongest).size());
    return clean.empty() ? "model" : clean;
}

}  // namespace

Result<IndexOutcome> index_models(Store& store, const IndexOptions& options, ProgressSink& sink,
                                  std::stop_token stop) {
    return IndexRun(store, options, sink, std::move(stop)).run();
}

Result<NewModel> describe_upload(const UploadedModel& upload, const IndexParameters& parameters,
                                 std::stop_token stop, ModelReader* reader) {
    auto model = describe_model({upload.bytes, upload.name, {}, reader, {}, {}, upload.inside},
                                parameters, std::move(stop));
    if (!model) return model;
    model->summary.name = clean_name(upload.name);
    model->summary.class_name = upload.class_name;
    return model;
}

Result<void> update_statistics(Store& store, int jobs, const std::stop_token& stop) {
    const auto state = store.collection_state();
    if (!state) return state.error();
    if (state->statistics == state->models) return {};
    const auto snapshot = Snapshot::load(store);
    if (!snapshot) return snapshot.error();
    return update_statistics(store, **snapshot, jobs, stop);
}

Result<void> update_statistics(Store& store, const Snapshot& snapshot, int jobs,
                               const std::stop_token& stop) {
    if (snapshot.state().statistics == snapshot.revision()) return {};
    StorePool stores(store);
    SnapshotDescriptors source(snapshot, stores, nullptr, jobs);
    const auto statistics = ranking::collection_statistics(source, jobs, stop);
    if (!statistics) return statistics.error();
    // Of models that change meanwhile it would be known at which revision they do not count.
    if (source.missed()) {
        return {ErrorCode::kIndexBusy, "the index changes while its models are measured"};
    }
    return store.put_statistics(*statistics, snapshot.revision(), snapshot.state().replacements);
}

}  // namespace ossuary::index
