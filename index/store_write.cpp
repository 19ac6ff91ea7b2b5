#include <cmath>
#include <set>

#include "index/codec.h"
#include "index/content_hash.h"
#include "index/store_impl.h"
#include "index/store_scan.h"
#include "index/timestamp.h"

namespace ossuary::index {

namespace {

/// The blobs of a model, ready to be written.
struct EncodedModel {
    std::string signature, descriptor, globals, skeleton, preview, segments, features, thumbnail;
};

/// Encodes, and decodes again to be sure that what is written can be read.
Result<EncodedModel> encode(const NewModel& model) {
    EncodedModel encoded;
    encoded.signature = encode_signature(model.descriptor.signature);
    encoded.descriptor = encode_descriptor(model.descriptor.skeleton);
    encoded.globals = encode_globals(model.descriptor.globals);
    encoded.skeleton = encode_skeleton(model.skeleton);
    encoded.preview = encode_preview(model.preview);
    std::string wrong;
    const auto check = [&wrong](const auto& decoded) {
        if (!decoded && wrong.empty()) wrong = decoded.error().message;
    };
    check(decode_signature(encoded.signature));
    check(decode_descriptor(encoded.descriptor));
    check(decode_globals(encoded.globals));
    check(decode_skeleton(encoded.skeleton));
    check(decode_preview(encoded.preview));
    if (model.segments) {
        encoded.segments = encode_segments(*model.segments);
        check(decode_segments(encoded.segments));
        if (model.segments->labels.size() * 3 != model.preview.triangles.size()) {
            wrong = "labels and triangles of the preview differ in number";
        }
    }
    if (!model.features.features.points.empty()) {
        encoded.features = encode_features(model.features);
        check(decode_features(encoded.features));
    }
    if (!model.thumbnail.empty()) {
        encoded.thumbnail = encode_thumbnail(model.thumbnail);
        check(decode_thumbnail(encoded.thumbnail));
    }
    if (model.descriptor.skeleton.branches.size() != model.skeleton.branches.size() ||
        model.descriptor.skeleton.nodes.size() != model.skeleton.nodes.size()) {
        wrong = "skeleton and descriptor differ in size";
    }
    if (!model.summary.bounds.min().allFinite() || !model.summary.bounds.max().allFinite()) {
        wrong = "bounds that are not finite";
    }
    if (!std::isfinite(model.summary.frame.metres_per_unit)) wrong = "a unit that is not finite";
    if (!wrong.empty()) {
        return {ErrorCode::kInternal, "a description that cannot be stored: " + wrong};
    }
    return encoded;
}

/// One transaction's worth of changes.
class Writer {
public:
    explicit Writer(Store::Impl& impl)
        : impl_(impl), transaction_(impl.database(), SQLite::TransactionBehavior::IMMEDIATE) {}

    Result<ModelId> operator()(const PutModel& change);
    Result<ModelId> operator()(const MoveModel& change);
    Result<ModelId> operator()(const ClassifyModel& change);
    Result<ModelId> operator()(const TurnModel& change);
    Result<ModelId> operator()(const RemoveModel& change);
    Result<ModelId> operator()(const RecordFailure& change);
    Result<ModelId> operator()(const ForgetFailure& change);
    Result<ModelId> operator()(const PutUpload& change);
    Result<ModelId> operator()(const FailUpload& change);
    Result<ModelId> operator()(const AddFeatures& change);

    Result<void> commit() {
        for (const std::int64_t block : changed_blocks_) {
            write_scan_block(*impl_.connection, block, revision(), fresh_);
        }
        return impl_.commit(transaction_);
    }

private:
    Query query(const std::string& sql) { return Query(impl_.statement(sql)); }

    /// This transaction's revision; it has none until a model changes.
    Revision revision() {
        if (revision_ == 0) {
            query("UPDATE state SET revision = revision + 1 WHERE id = 1").run();
            impl_.seal("state", "id = ?", 1);
            revision_ = impl_.connection->integer("SELECT revision FROM state WHERE id = 1");
        }
        return revision_;
    }
    struct Existing {
        ModelId id = 0;
        std::string content_hash;
    };
    std::optional<Existing> existing(const std::string& path, const std::string& content_hash);
    ModelId put_row(const ModelSummary& summary, std::optional<ModelId> id);
    void put_parts(ModelId id, const NewModel& model, const EncodedModel& encoded);
    void put_orientation(ModelId id, const Orientation& orientation);
    void put_frame(ModelId id, const FileFrame& frame);
    Result<ModelId> put(const NewModel& model);
    void forget_failure(const std::string& path) {
        query("DELETE FROM failures WHERE path = ?").bind(path).run();
    }
    void remove_parts(ModelId id);
    /// Removes the models that fit; whether there were any.
    bool remove_where(const std::string& where, const std::string& path, const auto& value);
    void has_changed(ModelId id) { changed_blocks_.insert(id / kScanBlockModels); }

    Store::Impl& impl_;
    SQLite::Transaction transaction_;
    Revision revision_ = 0;
    std::set<std::int64_t> changed_blocks_;
    FreshRows fresh_;
};

bool Writer::remove_where(const std::string& where, const std::string& path, const auto& value) {
    std::vector<ModelId> ids;
    {
        Query found(impl_.statement("SELECT id FROM models WHERE " + where));
        found.bind(path, value);
        while (found.step()) ids.push_back(found.integer(0));
    }
    for (const ModelId id : ids) {
        query("DELETE FROM models WHERE id = ?").bind(id).run();
        has_changed(id);
    }
    return !ids.empty();
}

/// The model that stands for `path`, or for an upload (no path) of these bytes.
std::optional<Writer::Existing> Writer::existing(const std::string& path,
                                                 const std::string& content_hash) {
    Query found(impl_.statement(
        path.empty() ? "SELECT id, content_hash FROM models WHERE path IS NULL AND content_hash = ?"
                     : "SELECT id, content_hash FROM models WHERE path = ?"));
    if (!found.bind(path.empty() ? content_hash : path).step()) return {};
    return Existing{found.integer(0), found.text(1)};
}

ModelId Writer::put_row(const ModelSummary& summary, std::optional<ModelId> id) {
    static const std::string kInsert =
        "INSERT INTO models (" + std::string(kSummaryColumns) +
        ", revision) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
        "ON CONFLICT (id) DO UPDATE SET path = excluded.path, name = excluded.name, "
        "class = excluded.class, content_hash = excluded.content_hash, "
        "vertices = excluded.vertices, faces = excluded.faces, nodes = excluded.nodes, "
        "branches = excluded.branches, min_x = excluded.min_x, min_y = excluded.min_y, "
        "min_z = excluded.min_z, max_x = excluded.max_x, max_y = excluded.max_y, "
        "max_z = excluded.max_z, surface_area = excluded.surface_area, "
        "warnings = excluded.warnings, indexed_at = excluded.indexed_at, "
        "revision = excluded.revision";
    Query insert(impl_.statement(kInsert));
    const Vec3 low = summary.bounds.min();
    const Vec3 high = summary.bounds.max();
    insert.bind(std::int64_t{0}, summary.path, summary.name, summary.class_name,
                summary.content_hash, summary.vertices, summary.faces, summary.nodes,
                summary.branches, low.x(), low.y(), low.z(), high.x(), high.y(), high.z(),
                summary.surface_area, encode_warnings(summary.warnings), utc_now(), revision());
    if (id) {
        insert.bind_at(1, *id);
    } else {
        insert.bind_at(1, nullptr);
    }
    if (summary.path.empty()) insert.bind_at(2, nullptr);
    insert.run();
    const ModelId given = id ? *id : impl_.database().getLastInsertRowid();
    impl_.seal("models", "id = ?", given);
    has_changed(given);
    return given;
}

void Writer::remove_parts(ModelId id) {
    for (const char* table : {"signatures", "descriptors", "skeletons", "branches", "previews",
                              "segments", "surface_features", "thumbnails"}) {
        query("DELETE FROM " + std::string(table) + " WHERE model = ?").bind(id).run();
    }
}

void Writer::put_parts(ModelId id, const NewModel& model, const EncodedModel& encoded) {
    query("INSERT INTO signatures (model, signature) VALUES (?, ?)")
        .bind(id, BlobView{encoded.signature})
        .run();
    query("INSERT INTO descriptors (model, skeleton, globals) VALUES (?, ?, ?)")
        .bind(id, BlobView{encoded.descriptor}, BlobView{encoded.globals})
        .run();
    query("INSERT INTO skeletons (model, skeleton) VALUES (?, ?)")
        .bind(id, BlobView{encoded.skeleton})
        .run();
    query("INSERT INTO previews (model, mesh) VALUES (?, ?)")
        .bind(id, BlobView{encoded.preview})
        .run();
    if (!encoded.segments.empty()) {
        query("INSERT INTO segments (model, segments) VALUES (?, ?)")
            .bind(id, BlobView{encoded.segments})
            .run();
    }
    if (!encoded.features.empty()) {
        query("INSERT INTO surface_features (model, features) VALUES (?, ?)")
            .bind(id, BlobView{encoded.features})
            .run();
    }
    if (!encoded.thumbnail.empty()) {
        query("INSERT INTO thumbnails (model, png) VALUES (?, ?)")
            .bind(id, BlobView{encoded.thumbnail})
            .run();
    }
    for (std::size_t i = 0; i < model.skeleton.branches.size(); ++i) {
        const skeleton::SkeletonGraph::Branch& branch = model.skeleton.branches[i];
        query(
            "INSERT INTO branches (model, branch, node_a, node_b, length, chain_code) "
            "VALUES (?, ?, ?, ?, ?, ?)")
            .bind(id, static_cast<std::int64_t>(i), branch.a, branch.b, branch.length(),
                  model.descriptor.skeleton.branches[i].chain_code)
            .run();
    }
}

void Writer::put_orientation(ModelId id, const Orientation& orientation) {
    query(
        "INSERT INTO orientations (model, up, said_by) VALUES (?, ?, ?) ON CONFLICT (model) DO "
        "UPDATE SET up = excluded.up, said_by = excluded.said_by")
        .bind(id, to_string(orientation.up),
              std::string_view(orientation.said_by_person ? "person" : "program"))
        .run();
}

void Writer::put_frame(ModelId id, const FileFrame& frame) {
    Query put(impl_.statement(
        "INSERT INTO file_frames (model, metres_per_unit, up) VALUES (?, ?, ?) ON CONFLICT (model) "
        "DO UPDATE SET metres_per_unit = excluded.metres_per_unit, up = excluded.up"));
    put.bind(id, nullptr, nullptr);
    if (frame.metres_per_unit > 0.0) put.bind_at(2, frame.metres_per_unit);
    if (frame.up) put.bind_at(3, to_string(*frame.up));
    put.run();
    impl_.seal("file_frames", "model = ?", id);
}

Result<ModelId> Writer::operator()(const PutModel& change) { return put(change.model); }

Result<ModelId> Writer::put(const NewModel& model) {
    assert(is_content_hash(model.summary.content_hash));
    const auto old = existing(model.summary.path, model.summary.content_hash);
    if (old && old->content_hash == model.summary.content_hash) return old->id;
    const auto encoded = encode(model);
    if (!encoded) return encoded.error();
    if (old) remove_parts(old->id);
    ModelSummary summary = model.summary;
    summary.nodes = static_cast<std::uint32_t>(model.skeleton.nodes.size());
    summary.branches = static_cast<std::uint32_t>(model.skeleton.branches.size());
    const ModelId id = put_row(summary, old ? std::optional(old->id) : std::nullopt);
    put_parts(id, model, *encoded);
    fresh_[id] = {};
    fresh_[id].append(model.descriptor);
    put_orientation(id, summary.orientation);
    put_frame(id, summary.frame);
    forget_failure(summary.path);
    return id;
}

Result<ModelId> Writer::operator()(const MoveModel& change) {
    remove_where("path = ? AND id <> ?", change.path, change.id);
    Query move(impl_.statement(
        "UPDATE models SET path = ?2, name = ?3, class = coalesce(?4, class), revision = ?5 "
        "WHERE id = ?1"));
    move.bind(change.id, change.path, change.name, nullptr, revision());
    if (change.class_name) move.bind_at(4, *change.class_name);
    if (move.run() == 0) return impl_.no_model(change.id);
    impl_.seal("models", "id = ?", change.id);
    has_changed(change.id);
    forget_failure(change.path);
    return change.id;
}

Result<ModelId> Writer::operator()(const ClassifyModel& change) {
    Query classify(impl_.statement("UPDATE models SET class = ?2, revision = ?3 WHERE id = ?1"));
    if (classify.bind(change.id, change.class_name, revision()).run() == 0) {
        return impl_.no_model(change.id);
    }
    impl_.seal("models", "id = ?", change.id);
    has_changed(change.id);
    return change.id;
}

Result<ModelId> Writer::operator()(const TurnModel& change) {
    {
        Query found(impl_.statement("SELECT 1 FROM models WHERE id = ?"));
        if (!found.bind(change.id).step()) return impl_.no_model(change.id);
    }
    put_orientation(change.id, change.orientation);
    if (change.thumbnail) {
        const std::string encoded = encode_thumbnail(*change.thumbnail);
        query(
            "INSERT INTO thumbnails (model, png) VALUES (?, ?) ON CONFLICT (model) DO UPDATE SET "
            "png = excluded.png")
            .bind(change.id, BlobView{encoded})
            .run();
    }
    return change.id;
}

Result<ModelId> Writer::operator()(const RemoveModel& change) {
    if (query("DELETE FROM models WHERE id = ?").bind(change.id).run() == 0) {
        return impl_.no_model(change.id);
    }
    revision();
    has_changed(change.id);
    return change.id;
}

Result<ModelId> Writer::operator()(const RecordFailure& change) {
    if (!change.content_hash.empty()) {
        if (remove_where("path = ? AND content_hash <> ?", change.path, change.content_hash)) {
            revision();
        }
    }
    query(
        "INSERT INTO failures (path, content_hash, code, message, failed_at) "
        "VALUES (?, ?, ?, ?, ?) ON CONFLICT (path) DO UPDATE SET "
        "content_hash = excluded.content_hash, code = excluded.code, "
        "message = excluded.message, failed_at = excluded.failed_at")
        .bind(change.path, change.content_hash, to_string(change.error.code), change.error.message,
              utc_now())
        .run();
    impl_.seal("failures", "path = ?", change.path);
    return ModelId{0};
}

Result<ModelId> Writer::operator()(const ForgetFailure& change) {
    forget_failure(change.path);
    return ModelId{0};
}

Result<ModelId> Writer::operator()(const PutUpload& change) {
    auto id = put(change.model);
    if (!id) return id;
    const auto finished = finish_upload(impl_, change.upload, {.model = *id, .error = {}});
    if (!finished) return finished.error();
    return id;
}

Result<ModelId> Writer::operator()(const FailUpload& change) {
    const auto finished = finish_upload(impl_, change.upload, {.model = 0, .error = change.error});
    if (!finished) return finished.error();
    return ModelId{0};
}

Result<ModelId> Writer::operator()(const AddFeatures& change) {
    const std::string encoded = encode_features(change.features);
    if (const auto checked = decode_features(encoded); !checked) return checked.error();
    query(
        "INSERT INTO surface_features (model, features) SELECT id, ?2 FROM models "
        "WHERE id = ?1 AND revision = ?3 ON CONFLICT (model) DO NOTHING")
        .bind(change.id, BlobView{encoded}, change.changed_at)
        .run();
    return change.id;
}

}  // namespace

Result<std::vector<ModelId>> Store::apply(std::span<const Change> changes) {
    return impl_->locked([&]() -> Result<std::vector<ModelId>> {
        std::vector<ModelId> ids;
        ids.reserve(changes.size());
        Writer writer(*impl_);
        for (const Change& change : changes) {
            const auto id = std::visit(writer, change);
            if (!id) return id.error();
            ids.push_back(*id);
        }
        if (const auto committed = writer.commit(); !committed) return committed.error();
        return ids;
    });
}

Result<ModelId> Store::put(NewModel model) {
    const Change change = PutModel{std::move(model)};
    const auto ids = apply({&change, 1});
    if (!ids) return ids.error();
    return ids->front();
}

Result<void> Store::remove(ModelId id) {
    const Change change = RemoveModel{id};
    const auto ids = apply({&change, 1});
    if (!ids) return ids.error();
    return {};
}

}  // namespace ossuary::index
