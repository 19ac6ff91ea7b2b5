// What is computed over the whole collection: statistics and evaluations.

#include "index/codec.h"
#include "index/store_impl.h"
#include "index/timestamp.h"

namespace ossuary::index {

Result<std::optional<StoredStatistics>> Store::statistics() {
    return impl_->locked([&]() -> Result<std::optional<StoredStatistics>> {
        Query query(impl_->statement("SELECT revision, statistics FROM statistics"));
        if (!query.step()) return std::optional<StoredStatistics>();
        auto statistics = decode_statistics(query.blob(1));
        if (!statistics) return statistics.error();
        return std::optional(StoredStatistics{*std::move(statistics), query.integer(0)});
    });
}

Result<void> Store::put_statistics(const ranking::CollectionStatistics& statistics,
                                   Revision revision, std::optional<std::uint64_t> replacements) {
    return impl_->locked([&]() -> Result<void> {
        if (replacements.value_or(impl_->replacements()) != impl_->replacements()) {
            return impl_->was_replaced();
        }
        SQLite::Transaction transaction(impl_->database(), SQLite::TransactionBehavior::IMMEDIATE);
        const std::string blob = encode_statistics(statistics);
        Query query(impl_->statement(
            "INSERT INTO statistics (id, revision, statistics) VALUES (1, ?, ?) "
            "ON CONFLICT (id) DO UPDATE SET revision = excluded.revision, "
            "statistics = excluded.statistics WHERE excluded.revision >= revision"));
        query.bind(revision, BlobView{blob}).run();
        impl_->seal("statistics", "id = ?", 1);
        return impl_->commit(transaction);
    });
}

Result<std::optional<StoredEvaluation>> Store::evaluation(const EvaluationKey& key) {
    return impl_->locked([&]() -> Result<std::optional<StoredEvaluation>> {
        if (key.replacements != impl_->replacements()) {
            return std::optional<StoredEvaluation>();
        }
        Query query(impl_->statement(
            "SELECT report, computed_at FROM evaluations WHERE revision = ? AND ranker = ? "
            "AND rerank = ? AND pose = ? AND collection_hash = ?"));
        query.bind(key.revision, to_string(key.ranker), key.rerank ? 1 : 0, key.pose,
                   key.collection_hash);
        if (!query.step()) return std::optional<StoredEvaluation>();
        auto report = decode_report(query.blob(0));
        if (!report) return report.error();
        return std::optional(StoredEvaluation{key, *std::move(report), query.text(1)});
    });
}

Result<std::vector<StoredEvaluation>> Store::evaluations() {
    return impl_->locked([&]() -> Result<std::vector<StoredEvaluation>> {
        std::vector<StoredEvaluation> evaluations;
        Query query(impl_->statement(
            "SELECT revision, ranker, rerank, pose, collection_hash, report, computed_at "
            "FROM evaluations WHERE revision = (SELECT revision FROM state) "
            "ORDER BY computed_at DESC, ranker, rerank, pose, collection_hash"));
        while (query.step()) {
            const auto ranker = ranking::parse_ranker(query.text(1));
            if (!ranker) return Error{ErrorCode::kIndexCorrupt, ranker.error().message};
            auto report = decode_report(query.blob(5));
            if (!report) return report.error();
            evaluations.push_back({{query.integer(0), *ranker, query.integer(2) != 0, query.real(3),
                                    query.text(4), impl_->replacements()},
                                   *std::move(report),
                                   query.text(6)});
        }
        return evaluations;
    });
}

Result<void> Store::put_evaluation(const EvaluationKey& key,
                                   const ranking::RetrievalReport& report) {
    return impl_->locked([&]() -> Result<void> {
        if (key.replacements != impl_->replacements()) return impl_->was_replaced();
        SQLite::Transaction transaction(impl_->database(), SQLite::TransactionBehavior::IMMEDIATE);
        Query(impl_->statement("DELETE FROM evaluations WHERE revision < "
                               "(SELECT revision FROM state)"))
            .run();
        const std::string blob = encode_report(report);
        Query insert(impl_->statement(
            "INSERT INTO evaluations (revision, ranker, rerank, pose, collection_hash, "
            "computed_at, report) VALUES (?, ?, ?, ?, ?, ?, ?) "
            "ON CONFLICT DO UPDATE SET computed_at = excluded.computed_at, "
            "report = excluded.report, checksum = NULL"));
        insert
            .bind(key.revision, to_string(key.ranker), key.rerank ? 1 : 0, key.pose,
                  key.collection_hash, utc_now(), BlobView{blob})
            .run();
        impl_->seal("evaluations", "checksum IS NULL AND revision = ?", key.revision);
        return impl_->commit(transaction);
    });
}

}  // namespace ossuary::index
