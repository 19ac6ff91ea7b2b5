#include <algorithm>

#include "engine/core/parallel.h"
#include "index/codec.h"
#include "index/store_impl.h"

namespace ossuary::index {

namespace {

std::uint32_t count_from(const Query& query, int column) {
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(query.integer(column), 0, std::int64_t{0xFFFFFFFF}));
}

Failure failure_from(const Query& query) {
    return {query.text(0), query.text(1), query.text(2), query.text(3), query.text(4)};
}

constexpr std::string_view kSelectFailures =
    "SELECT path, content_hash, code, message, failed_at FROM failures ";

constexpr std::string_view kSelectDescriptor =
    "SELECT d.skeleton, d.globals, s.signature, m.revision FROM models m "
    "JOIN descriptors d ON d.model = m.id JOIN signatures s ON s.model = m.id WHERE m.id = ?";

/// The WHERE clause of a page; parameters: after, class or NULL, part of the name.
constexpr std::string_view kPageFilter =
    "WHERE id > ?1 AND (?2 IS NULL OR class = ?2) "
    "AND (?3 = '' OR instr(lower(name), lower(?3)) > 0)";

void bind_filter(Query& query, const ModelFilter& filter, ModelId after) {
    if (filter.class_name) {
        query.bind(after, *filter.class_name, filter.name_contains);
    } else {
        query.bind(after, nullptr, filter.name_contains);
    }
}

}  // namespace

std::string select_summaries(std::string_view rest) {
    return "SELECT " + std::string(kSummaryColumns) + ", " + std::string(kStandingColumns) +
           " FROM models " + std::string(rest);
}

Result<ModelSummary> summary_from(const Query& query) {
    ModelSummary summary;
    summary.id = query.integer(0);
    if (!query.is_null(1)) summary.path = query.text(1);
    summary.name = query.text(2);
    summary.class_name = query.text(3);
    summary.content_hash = query.text(4);
    summary.vertices = count_from(query, 5);
    summary.faces = count_from(query, 6);
    summary.nodes = count_from(query, 7);
    summary.branches = count_from(query, 8);
    summary.bounds.min() = {query.real(9), query.real(10), query.real(11)};
    summary.bounds.max() = {query.real(12), query.real(13), query.real(14)};
    summary.surface_area = query.real(15);
    auto warnings = decode_warnings(query.text(16));
    if (!warnings) {
        return {warnings.error().code,
                "model " + std::to_string(summary.id) + ": " + warnings.error().message};
    }
    summary.warnings = *std::move(warnings);
    summary.indexed_at = query.text(17);
    return summary;
}

Result<ModelSummary> selected_summary(const Query& query) {
    constexpr int kUp = kSummaryColumnCount;
    constexpr int kSaidBy = kUp + 1, kUnit = kUp + 2, kFileUp = kUp + 3;
    auto summary = summary_from(query);
    if (!summary) return summary;
    const auto damaged = [&](const Error& error) -> Error {
        return {ErrorCode::kIndexCorrupt,
                "model " + std::to_string(summary->id) + ": " + error.message};
    };
    if (!query.is_null(kUp)) {
        const auto up = parse_up(query.text(kUp));
        if (!up) return damaged(up.error());
        summary->orientation = {*up, query.text(kSaidBy) == "person"};
    }
    if (!query.is_null(kUnit)) summary->frame.metres_per_unit = query.real(kUnit);
    if (!query.is_null(kFileUp)) {
        const auto up = parse_up(query.text(kFileUp));
        if (!up) return damaged(up.error());
        summary->frame.up = *up;
    }
    return summary;
}

Result<descriptor::ModelDescriptor> descriptor_from(std::string_view skeleton,
                                                    std::string_view globals,
                                                    std::string_view signature) {
    descriptor::ModelDescriptor descriptor;
    auto decoded_skeleton = decode_descriptor(skeleton);
    if (!decoded_skeleton) return decoded_skeleton.error();
    auto decoded_globals = decode_globals(globals);
    if (!decoded_globals) return decoded_globals.error();
    auto decoded_signature = decode_signature(signature);
    if (!decoded_signature) return decoded_signature.error();
    descriptor.skeleton = *std::move(decoded_skeleton);
    descriptor.globals = *std::move(decoded_globals);
    descriptor.signature = *std::move(decoded_signature);
    matching::derive_matching_data(descriptor.skeleton);
    return descriptor;
}

Result<Work> Store::claim_work(std::string_view path, std::string_view content_hash) {
    return impl_->locked([&]() -> Result<Work> {
        Work work;
        {
            Query failed(impl_->statement(std::string(kSelectFailures) + "WHERE path = ?"));
            if (failed.bind(path).step()) work.failure = failure_from(failed);
        }
        {
            Query same_path(impl_->statement(select_summaries("WHERE path = ?")));
            if (same_path.bind(path).step()) {
                auto summary = selected_summary(same_path);
                if (same_path.text(4) == content_hash) {
                    if (!summary) return summary.error();
                    work.kind = Work::Kind::kUnchanged;
                    work.models.push_back(*std::move(summary));
                    return work;
                }
                // A damaged row goes when the file is described again.
                if (summary) work.earlier = *std::move(summary);
            }
        }
        if (work.failure && !content_hash.empty() && work.failure->content_hash == content_hash) {
            work.kind = Work::Kind::kKnownFailure;
            return work;
        }
        Query same_content(
            impl_->statement(select_summaries("WHERE content_hash = ? ORDER BY id")));
        same_content.bind(content_hash);
        while (same_content.step()) {
            auto summary = selected_summary(same_content);
            if (!summary) return summary.error();
            work.kind = Work::Kind::kSameContent;
            work.models.push_back(*std::move(summary));
        }
        return work;
    });
}

Result<ModelPage> Store::models(const ModelFilter& filter) {
    return impl_->locked([&]() -> Result<ModelPage> {
        SQLite::Transaction transaction(impl_->database());
        ModelPage page;
        page.revision = impl_->connection->integer("SELECT revision FROM state");
        {
            Query total(
                impl_->statement("SELECT count(*) FROM models " + std::string(kPageFilter)));
            bind_filter(total, filter, 0);
            total.step();
            page.total = static_cast<std::size_t>(total.integer(0));
        }
        Query query(
            impl_->statement(select_summaries(std::string(kPageFilter) + " ORDER BY id LIMIT ?4")));
        bind_filter(query, filter, filter.after);
        query.bind_at(
            4, filter.limit == 0 ? std::int64_t{-1} : static_cast<std::int64_t>(filter.limit) + 1);
        while (query.step()) {
            if (filter.limit != 0 && page.models.size() == filter.limit) {
                page.next = page.models.back().id;
                break;
            }
            auto summary = selected_summary(query);
            if (!summary) return summary.error();
            page.models.push_back(*std::move(summary));
        }
        return page;
    });
}

Result<ModelSummary> Store::model(ModelId id) {
    return impl_->locked([&]() -> Result<ModelSummary> {
        Query query(impl_->statement(select_summaries("WHERE id = ?")));
        if (!query.bind(id).step()) return impl_->no_model(id);
        return selected_summary(query);
    });
}

Result<std::vector<ModelSummary>> Store::models_named(std::string_view name) {
    return impl_->locked([&]() -> Result<std::vector<ModelSummary>> {
        std::vector<ModelSummary> models;
        Query query(impl_->statement(select_summaries("WHERE name = ? ORDER BY id")));
        query.bind(name);
        while (query.step()) {
            auto summary = selected_summary(query);
            if (!summary) return summary.error();
            models.push_back(*std::move(summary));
        }
        return models;
    });
}

Result<std::vector<StoredDescriptor>> Store::descriptors(std::span<const ModelId> ids, int jobs) {
    struct Blobs {
        ModelId id = 0;
        Revision changed_at = 0;
        std::string skeleton, globals, signature;
    };
    const auto read = impl_->locked([&]() -> Result<std::vector<Blobs>> {
        SQLite::Transaction transaction(impl_->database());
        std::vector<Blobs> blobs;
        SQLite::Statement& statement = impl_->statement(std::string(kSelectDescriptor));
        for (const ModelId id : ids) {
            Query query(statement);
            if (!query.bind(id).step()) continue;
            blobs.push_back({id, query.integer(3), std::string(query.blob(0)),
                             std::string(query.blob(1)), std::string(query.blob(2))});
        }
        return blobs;
    });
    if (!read) return read.error();
    // Decoded while others may read.
    std::vector<StoredDescriptor> found(read->size());
    std::vector<std::optional<Error>> errors(read->size());
    parallel_for(read->size(), jobs, [&](std::size_t i) {
        const Blobs& blobs = (*read)[i];
        auto decoded = descriptor_from(blobs.skeleton, blobs.globals, blobs.signature);
        if (!decoded) {
            errors[i] = impl_->damaged(blobs.id, decoded.error());
            return;
        }
        found[i] = {blobs.id, blobs.changed_at, *std::move(decoded)};
    });
    for (const auto& error : errors) {
        if (error) return *error;
    }
    return found;
}

Result<std::vector<ListedModel>> Store::listed(ModelId first, ModelId last) {
    return impl_->locked([&]() -> Result<std::vector<ListedModel>> {
        std::vector<ListedModel> models;
        Query query(
            impl_->statement("SELECT id, name, class, path, indexed_at, faces, branches, "
                             "max(max_x - min_x, max_y - min_y, max_z - min_z), metres_per_unit "
                             "FROM models LEFT JOIN file_frames ON model = id "
                             "WHERE id BETWEEN ? AND ? ORDER BY id"));
        query.bind(first, last);
        while (query.step()) {
            models.push_back({query.integer(0), query.text(1), query.text(2), query.text(3),
                              query.text(4), count_from(query, 5), count_from(query, 6),
                              query.real(7), query.real(8)});
        }
        return models;
    });
}

Result<StoredSkeleton> Store::skeleton(ModelId id) {
    return impl_->locked([&]() -> Result<StoredSkeleton> {
        SQLite::Transaction transaction(impl_->database());
        Query query(impl_->statement("SELECT skeleton FROM skeletons WHERE model = ?"));
        if (!query.bind(id).step()) return impl_->no_model(id);
        auto graph = decode_skeleton(query.blob(0));
        if (!graph) return impl_->damaged(id, graph.error());
        StoredSkeleton skeleton{*std::move(graph), {}};
        Query codes(
            impl_->statement("SELECT chain_code FROM branches WHERE model = ? ORDER BY branch"));
        codes.bind(id);
        while (codes.step()) skeleton.chain_codes.push_back(codes.text(0));
        if (skeleton.chain_codes.size() != skeleton.graph.branches.size()) {
            return impl_->damaged(
                id, {ErrorCode::kIndexCorrupt, "chain codes and branches differ in number"});
        }
        return skeleton;
    });
}

Result<PreviewMesh> Store::preview(ModelId id) {
    return impl_->locked([&]() -> Result<PreviewMesh> {
        Query query(impl_->statement("SELECT mesh FROM previews WHERE model = ?"));
        if (!query.bind(id).step()) return impl_->no_model(id);
        auto mesh = decode_preview(query.blob(0));
        if (!mesh) return impl_->damaged(id, mesh.error());
        return mesh;
    });
}

Result<std::optional<ModelSegments>> Store::segments(ModelId id) {
    return impl_->locked([&]() -> Result<std::optional<ModelSegments>> {
        Query query(
            impl_->statement("SELECT s.segments FROM models m LEFT JOIN segments s "
                             "ON s.model = m.id WHERE m.id = ?"));
        if (!query.bind(id).step()) return impl_->no_model(id);
        if (query.is_null(0)) return std::optional<ModelSegments>();
        auto segments = decode_segments(query.blob(0));
        if (!segments) return impl_->damaged(id, segments.error());
        return std::optional(*std::move(segments));
    });
}

Result<std::vector<StoredFeatures>> Store::features(ModelId after, std::size_t limit, int jobs) {
    struct Blob {
        ModelId id = 0;
        Revision changed_at = 0;
        std::string features;
    };
    const auto read = impl_->locked([&]() -> Result<std::vector<Blob>> {
        std::vector<Blob> blobs;
        if (impl_->version < kFirstVersionWithFeatures) return blobs;
        Query query(
            impl_->statement("SELECT f.model, m.revision, f.features FROM surface_features f "
                             "JOIN models m ON m.id = f.model WHERE f.model > ? "
                             "ORDER BY f.model LIMIT ?"));
        query.bind(after, static_cast<std::int64_t>(limit));
        while (query.step()) {
            blobs.push_back({query.integer(0), query.integer(1), std::string(query.blob(2))});
        }
        return blobs;
    });
    if (!read) return read.error();
    // Decoded while others may read.
    std::vector<StoredFeatures> found(read->size());
    std::vector<std::optional<Error>> errors(read->size());
    parallel_for(read->size(), jobs, [&](std::size_t i) {
        const Blob& blob = (*read)[i];
        auto decoded = decode_features(blob.features);
        if (decoded) {
            found[i] = {blob.id, blob.changed_at, *std::move(decoded)};
        } else {
            errors[i] = impl_->damaged(blob.id, decoded.error());
        }
    });
    for (const auto& error : errors) {
        if (error) return *error;
    }
    return found;
}

Result<std::vector<StoredFeatures>> Store::without_features(ModelId after, std::size_t limit) {
    return impl_->locked([&]() -> Result<std::vector<StoredFeatures>> {
        std::vector<StoredFeatures> models;
        if (impl_->version < kFirstVersionWithFeatures) return models;
        Query query(impl_->statement(
            "SELECT id, revision FROM models WHERE id > ? AND NOT EXISTS (SELECT 1 "
            "FROM surface_features WHERE model = id) ORDER BY id LIMIT ?"));
        query.bind(after, static_cast<std::int64_t>(limit));
        while (query.step()) models.push_back({query.integer(0), query.integer(1), {}});
        return models;
    });
}

Result<std::vector<std::uint8_t>> Store::thumbnail(ModelId id) {
    return impl_->locked([&]() -> Result<std::vector<std::uint8_t>> {
        Query query(impl_->statement("SELECT png FROM thumbnails WHERE model = ?"));
        if (!query.bind(id).step()) return impl_->no_model(id);
        auto png = decode_thumbnail(query.blob(0));
        if (!png) return impl_->damaged(id, png.error());
        return png;
    });
}

Result<std::vector<Failure>> Store::failures() {
    return impl_->locked([&]() -> Result<std::vector<Failure>> {
        std::vector<Failure> failures;
        Query query(impl_->statement(std::string(kSelectFailures) + "ORDER BY path"));
        while (query.step()) failures.push_back(failure_from(query));
        return failures;
    });
}

}  // namespace ossuary::index
