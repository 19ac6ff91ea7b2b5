#include <set>

#include "index/migrations.h"
#include "index/store_scan.h"
#include "index/store_verify_rows.h"

namespace ossuary::index {

namespace {

bool same_row(const ranking::ScanRow& a, const ranking::ScanRow& b) {
    return std::equal(a.signature.begin(), a.signature.end(), b.signature.begin()) &&
           std::equal(a.sketch.begin(), a.sketch.end(), b.sketch.begin()) &&
           a.information == b.information && a.key == b.key;
}

/// Compares a block with what it should be; of models whose descriptors are damaged, which is told
/// elsewhere, all but their rows.
std::string difference(const ScanBlock& found, const ScanBlock& expected) {
    if (found.ids != expected.ids) return "its models are others than the index has";
    ranking::ScanRows damaged;
    damaged.append(descriptor::ModelDescriptor());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::string model = "model " + std::to_string(found.ids[i]) + ": ";
        if (found.changed_at[i] != expected.changed_at[i]) return model + "revisions disagree";
        if (found.class_name(i) != expected.class_name(i)) return model + "classes disagree";
        if (found.measures[i] != expected.measures[i]) return model + "measures disagree";
        if (same_row(expected.rows.row(i), damaged.row(0))) continue;
        if (!same_row(found.rows.row(i), expected.rows.row(i))) {
            return model + "its row is not that of its descriptor";
        }
    }
    return {};
}

}  // namespace

void verify_scan(Store::Impl& impl, VerifyReport& report) {
    Connection& connection = *impl.connection;
    std::set<std::int64_t> numbers;
    {
        Query models(impl.statement("SELECT DISTINCT id / " + std::to_string(kScanBlockModels) +
                                    " FROM models UNION SELECT block FROM scan_blocks"));
        while (models.step()) numbers.insert(models.integer(0));
    }
    for (const std::int64_t number : numbers) {
        const auto find = [&](std::string what) {
            report.findings.push_back({"block " + std::to_string(number), std::move(what)});
        };
        Query row(impl.statement("SELECT revision, models FROM scan_blocks WHERE block = ?"));
        if (!row.bind(number).step()) {
            find("missing: searches do not see its models");
            continue;
        }
        ++report.blobs;
        if (row.integer(0) > report.revision) find("changed at a revision that is still to come");
        const auto decoded = decode_scan_block(row.blob(1));
        if (!decoded) {
            find(decoded.error().message);
            continue;
        }
        if (auto what = difference(*decoded, make_scan_block(connection, number, {}, nullptr));
            !what.empty()) {
            find(std::move(what));
        }
    }
}

}  // namespace ossuary::index
