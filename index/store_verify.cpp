#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "index/blob.h"
#include "index/codec.h"
#include "index/content_hash.h"
#include "index/migrations.h"
#include "index/store_impl.h"
#include "index/store_verify_rows.h"

namespace ossuary::index {

namespace {

/// What all descriptors of one index have in common.
struct DescriptorShape {
    std::vector<std::pair<std::string, std::size_t>> globals;
    std::size_t signature = 0;
    bool operator==(const DescriptorShape&) const = default;
};

class Verifier {
public:
    explicit Verifier(Store::Impl& impl) : impl_(impl) {}

    VerifyReport run() {
        SQLite::Transaction transaction(impl_.database());
        report_.version = impl_.version;
        check_database();
        check_parameters();
        check_state();
        check_models();
        check_failures();
        if (impl_.version >= kFirstVersionWithCollection) check_collection();
        verify_schema(impl_, report_);
        if (impl_.version >= kFirstVersionWithUploads) {
            verify_checksums(impl_, report_);
            verify_uploads(impl_, report_);
        }
        if (impl_.version >= kFirstVersionWithScan) verify_scan(impl_, report_);
        return std::move(report_);
    }

private:
    void find(std::string subject, std::string message) {
        report_.findings.push_back({std::move(subject), std::move(message)});
    }
    template <typename T>
    bool decoded(const std::string& subject, const Result<T>& result) {
        ++report_.blobs;
        if (!result) find(subject, result.error().message);
        return result.ok();
    }

    // SQLite reads a last page that is cut short as if zeros followed, and finds nothing wrong when
    // only unused bytes are missing.
    void check_size() {
        std::error_code error;
        const auto bytes = std::filesystem::file_size(impl_.path, error);
        if (error) return find("file", "its size cannot be read: " + error.message());
        const auto page_bytes =
            static_cast<std::uintmax_t>(impl_.connection->integer("PRAGMA page_size"));
        if (bytes % page_bytes != 0) {
            find("file", std::to_string(bytes) + " bytes are not a whole number of pages of " +
                             std::to_string(page_bytes));
        }
    }
    void check_database() {
        check_size();
        Query integrity(impl_.statement("PRAGMA integrity_check(20)"));
        while (integrity.step()) {
            if (integrity.text(0) != "ok") find("file", integrity.text(0));
        }
        Query keys(impl_.statement("PRAGMA foreign_key_check"));
        while (keys.step()) {
            find("table " + keys.text(0), "a row belongs to a model that is not there");
        }
    }
    void check_parameters() {
        const auto parameters = read_parameters(*impl_.connection, impl_.path);
        if (!parameters) find("parameters", parameters.error().message);
    }
    void check_state() {
        Query state(impl_.statement("SELECT revision FROM state WHERE id = 1"));
        if (!state.step()) {
            find("state", "no revision");
        } else {
            report_.revision = state.integer(0);
        }
    }
    void check_models() {
        Query models(impl_.statement("SELECT " + std::string(kSummaryColumns) +
                                     ", revision, typeof(path) FROM models ORDER BY id"));
        while (models.step()) {
            ++report_.models;
            const ModelId id = models.integer(0);
            const std::string subject = "model " + std::to_string(id);
            const auto summary = summary_from(models);
            if (!summary) {
                find(subject, summary.error().message);
                continue;
            }
            check_summary(subject, *summary);
            if (models.integer(kSummaryColumnCount) > report_.revision) {
                find(subject, "changed at a revision that is still to come");
            }
            check_parts(subject, *summary);
        }
    }
    void check_summary(const std::string& subject, const ModelSummary& summary) {
        if (!is_content_hash(summary.content_hash)) {
            find(subject, "content hash is not 32 hexadecimal digits");
        }
        if (summary.name.empty()) find(subject, "no name");
        const Vec3 extent = summary.bounds.max() - summary.bounds.min();
        if (!extent.allFinite() || extent.minCoeff() < 0.0) find(subject, "bounds are no box");
        if (!std::isfinite(summary.surface_area) || summary.surface_area < 0.0) {
            find(subject, "surface area is no area");
        }
    }
    void check_parts(const std::string& subject, const ModelSummary& summary) {
        DescriptorShape shape;
        matching::SkeletonDescriptor descriptor;
        Query blobs(impl_.statement("SELECT skeleton, globals FROM descriptors WHERE model = ?"));
        if (!blobs.bind(summary.id).step()) {
            find(subject, "no descriptor");
        } else {
            auto read = decode_descriptor(blobs.blob(0));
            if (decoded(subject + ", descriptor", read)) descriptor = *std::move(read);
            const auto globals = decode_globals(blobs.blob(1));
            if (decoded(subject + ", globals", globals)) {
                for (const auto& global : *globals) {
                    shape.globals.emplace_back(global.name, global.values.size());
                }
            }
        }
        Query signature(impl_.statement("SELECT signature FROM signatures WHERE model = ?"));
        if (!signature.bind(summary.id).step()) {
            find(subject, "no signature");
        } else {
            const auto read = decode_signature(signature.blob(0));
            if (decoded(subject + ", signature", read)) shape.signature = read->size();
        }
        if (!shape_) shape_ = shape;
        if (*shape_ != shape) find(subject, "descriptors of another kind than the first model's");
        check_skeleton(subject, summary, descriptor);
        check_pictures(subject, summary.id);
        check_segments(subject, summary);
        check_frame(subject, summary.id);
        check_features(subject, summary.id);
    }
    void check_features(const std::string& subject, ModelId id) {
        if (impl_.version < kFirstVersionWithFeatures) return;
        Query row(impl_.statement("SELECT features FROM surface_features WHERE model = ?"));
        if (!row.bind(id).step()) return;
        (void)decoded(subject + ", features", decode_features(row.blob(0)));
    }
    void check_frame(const std::string& subject, ModelId id) {
        if (impl_.version < kFirstVersionWithFrames) return;
        Query row(impl_.statement("SELECT metres_per_unit, up FROM file_frames WHERE model = ?"));
        if (!row.bind(id).step()) return;
        if (!row.is_null(0) && !(std::isfinite(row.real(0)) && row.real(0) > 0.0)) {
            find(subject, "its file's unit is no length");
        }
        if (!row.is_null(1) && !parse_up(row.text(1))) {
            find(subject, "the axis that its file says is up is none");
        }
    }
    void check_skeleton(const std::string& subject, const ModelSummary& summary,
                        const matching::SkeletonDescriptor& descriptor) {
        Query blob(impl_.statement("SELECT skeleton FROM skeletons WHERE model = ?"));
        if (!blob.bind(summary.id).step()) {
            find(subject, "no skeleton");
            return;
        }
        const auto skeleton = decode_skeleton(blob.blob(0));
        if (!decoded(subject + ", skeleton", skeleton)) return;
        if (skeleton->nodes.size() != summary.nodes ||
            skeleton->branches.size() != summary.branches ||
            descriptor.nodes.size() != summary.nodes ||
            descriptor.branches.size() != summary.branches) {
            find(subject, "numbers of nodes or branches disagree");
            return;
        }
        std::size_t next = 0;
        Query rows(
            impl_.statement("SELECT branch, node_a, node_b, chain_code, length "
                            "FROM branches WHERE model = ? ORDER BY branch"));
        rows.bind(summary.id);
        for (; rows.step(); ++next) {
            if (next >= skeleton->branches.size()) continue;
            const skeleton::SkeletonGraph::Branch& branch = skeleton->branches[next];
            if (rows.integer(0) != static_cast<std::int64_t>(next) || rows.integer(1) != branch.a ||
                rows.integer(2) != branch.b || rows.real(4) != branch.length() ||
                rows.text(3) != descriptor.branches[next].chain_code) {
                find(subject + ", branch " + std::to_string(next),
                     "row and blobs say different things");
            }
        }
        if (next != skeleton->branches.size()) find(subject, "branch rows missing or left over");
    }
    void check_pictures(const std::string& subject, ModelId id) {
        Query preview(impl_.statement("SELECT mesh FROM previews WHERE model = ?"));
        if (!preview.bind(id).step()) {
            find(subject, "no preview");
        } else {
            (void)decoded(subject + ", preview", decode_preview(preview.blob(0)));
        }
        Query thumbnail(impl_.statement("SELECT png FROM thumbnails WHERE model = ?"));
        if (thumbnail.bind(id).step()) {
            (void)decoded(subject + ", thumbnail", decode_thumbnail(thumbnail.blob(0)));
        }
    }
    void check_segments(const std::string& subject, const ModelSummary& summary) {
        if (impl_.version < kFirstVersionWithSegments) return;
        Query row(impl_.statement("SELECT segments FROM segments WHERE model = ?"));
        if (!row.bind(summary.id).step()) {
            const bool may_be_missing =
                impl_.parameters.pipeline < kFirstPipelineWithSegments ||
                std::any_of(summary.warnings.begin(), summary.warnings.end(),
                            [](const auto& each) { return each.code == kSegmentsMissing; });
            if (!may_be_missing) find(subject, "no parts, and no warning that says why");
            return;
        }
        const auto segments = decode_segments(row.blob(0));
        if (!decoded(subject + ", segments", segments)) return;
        Query preview(impl_.statement("SELECT mesh FROM previews WHERE model = ?"));
        if (preview.bind(summary.id).step()) {
            const auto mesh = decode_preview(preview.blob(0));
            if (mesh && mesh->triangles.size() != segments->labels.size() * 3) {
                find(subject, "labels and triangles of the preview differ in number");
            }
        }
        for (const auto& part : segments->parts) {
            if (part.branch >= 0 && static_cast<std::uint32_t>(part.branch) >= summary.branches) {
                find(subject, "a part belongs to a branch that is not there");
            }
        }
    }
    void check_failures() {
        std::set<std::string_view> known;
        for (const ErrorCodeName& name : kErrorCodeNames) known.insert(name.name);
        Query failures(impl_.statement("SELECT path, content_hash, code FROM failures"));
        while (failures.step()) {
            ++report_.failures;
            const std::string subject = "failure of " + failures.text(0);
            if (!known.contains(failures.text(2))) {
                find(subject, "code \"" + failures.text(2) + "\" is not known");
            }
            if (!failures.text(1).empty() && !is_content_hash(failures.text(1))) {
                find(subject, "content hash is not 32 hexadecimal digits");
            }
        }
    }
    void check_collection() {
        Query statistics(impl_.statement("SELECT revision, statistics FROM statistics"));
        if (statistics.step()) {
            (void)decoded("statistics", decode_statistics(statistics.blob(1)));
            if (statistics.integer(0) > report_.revision) {
                find("statistics", "made at a revision that is still to come");
            }
        } else if (report_.models > 0) {
            find("statistics", "missing: indexing did not come to its end, run it again");
        }
        Query evaluations(impl_.statement("SELECT ranker, report FROM evaluations"));
        while (evaluations.step()) {
            const std::string subject = "evaluation of " + evaluations.text(0);
            if (!ranking::parse_ranker(evaluations.text(0))) find(subject, "no such ranker");
            (void)decoded(subject, decode_report(evaluations.blob(1)));
        }
    }

    Store::Impl& impl_;
    VerifyReport report_;
    std::optional<DescriptorShape> shape_;
};

}  // namespace

Result<VerifyReport> Store::verify() {
    return impl_->locked([&]() -> Result<VerifyReport> { return Verifier(*impl_).run(); });
}

}  // namespace ossuary::index
