// What searches look at of a whole collection: blocks of models that are read without decoding.

#include "index/store_scan.h"

#include <algorithm>

#include "index/codec.h"
#include "index/store_impl.h"

namespace ossuary::index {

namespace {

/// Of each folder at the top of the machine the first and the last path; what lies in none of them
/// comes one by one.
std::vector<std::string> read_outer_paths(Connection& connection) {
    std::vector<std::string> paths;
    const auto next = [&](std::string_view sql, const auto&... values) -> std::string {
        Query query(connection.statement(std::string(sql)));
        return query.bind(values...).step() ? query.text(0) : std::string();
    };
    constexpr std::string_view kFrom =
        "SELECT path FROM models WHERE path >= ? ORDER BY path LIMIT 1";
    constexpr std::string_view kAfter =
        "SELECT path FROM models WHERE path > ? ORDER BY path LIMIT 1";
    constexpr std::string_view kLast =
        "SELECT path FROM models WHERE path >= ? AND path < ? ORDER BY path DESC LIMIT 1";
    std::string path = next(kFrom, std::string());
    while (!path.empty()) {
        paths.push_back(path);
        const std::size_t end = path.find('/', 1);
        if (path.front() != '/' || end == std::string::npos) {
            path = next(kAfter, path);
            continue;
        }
        // '0' is the character after the slash.
        const std::string top = path.substr(0, end);
        if (std::string last = next(kLast, top + '/', top + '0'); last != path) {
            paths.push_back(std::move(last));
        }
        path = next(kFrom, top + '0');
    }
    return paths;
}

/// A model's row of `models`, as far as its block repeats it.
struct ModelRow {
    ModelId id = 0;
    Revision revision = 0;
    std::string class_name;
    std::uint64_t measures = 0;
};

constexpr std::string_view kSelectRows =
    "SELECT id, revision, class, vertices, faces, surface_area, min_x, min_y, min_z, max_x, max_y, "
    "max_z FROM models WHERE id BETWEEN ? AND ? ORDER BY id";

std::vector<ModelRow> read_rows(Connection& connection, std::int64_t block) {
    std::vector<ModelRow> rows;
    Query query(connection.statement(std::string(kSelectRows)));
    const ModelId first = block * kScanBlockModels;
    query.bind(first, first + kScanBlockModels - 1);
    while (query.step()) {
        const Box3 bounds(Vec3(query.real(6), query.real(7), query.real(8)),
                          Vec3(query.real(9), query.real(10), query.real(11)));
        rows.push_back(
            {query.integer(0), query.integer(1), query.text(2),
             measures_key(static_cast<std::uint32_t>(query.integer(3)),
                          static_cast<std::uint32_t>(query.integer(4)), query.real(5), bounds)});
    }
    return rows;
}

/// From the stored descriptor. One that is damaged has an empty row: it is told by verify, and by
/// whoever comes upon it.
void append_stored(Connection& connection, ModelId id, ranking::ScanRows& rows) {
    descriptor::ModelDescriptor descriptor;
    Query query(
        connection.statement("SELECT d.skeleton, d.globals, s.signature FROM descriptors d "
                             "JOIN signatures s ON s.model = d.model WHERE d.model = ?"));
    if (query.bind(id).step()) {
        auto decoded = descriptor_from(query.blob(0), query.blob(1), query.blob(2));
        if (decoded) descriptor = *std::move(decoded);
    }
    rows.append(descriptor);
}

std::optional<ScanBlock> read_block(Connection& connection, std::int64_t number) {
    Query query(connection.statement("SELECT models FROM scan_blocks WHERE block = ?"));
    if (!query.bind(number).step()) return {};
    auto decoded = decode_scan_block(query.blob(0));
    // One that is damaged is made anew from what is stored.
    if (!decoded) return {};
    return *std::move(decoded);
}

}  // namespace

ScanBlock make_scan_block(Connection& connection, std::int64_t number, const FreshRows& fresh,
                          const ScanBlock* earlier) {
    ScanBlock block;
    for (const ModelRow& row : read_rows(connection, number)) {
        block.append(row.id, row.revision, row.measures, row.class_name);
        if (const auto found = fresh.find(row.id); found != fresh.end()) {
            block.rows.append(found->second.row(0));
            continue;
        }
        if (earlier != nullptr) {
            const auto& ids = earlier->ids;
            const auto at = std::lower_bound(ids.begin(), ids.end(), row.id);
            if (at != ids.end() && *at == row.id) {
                block.rows.append(earlier->rows.row(static_cast<std::size_t>(at - ids.begin())));
                continue;
            }
        }
        append_stored(connection, row.id, block.rows);
    }
    return block;
}

void write_scan_block(Connection& connection, std::int64_t number, Revision revision,
                      const FreshRows& fresh) {
    const auto earlier = read_block(connection, number);
    const std::string blob = encode_scan_block(
        make_scan_block(connection, number, fresh, earlier ? &*earlier : nullptr));
    Query(connection.statement("INSERT INTO scan_blocks (block, revision, models) VALUES (?, ?, ?) "
                               "ON CONFLICT (block) DO UPDATE SET revision = excluded.revision, "
                               "models = excluded.models"))
        .bind(number, revision, BlobView{blob})
        .run();
}

void fill_scan_blocks(Connection& connection) {
    const std::int64_t revision = connection.integer("SELECT revision FROM state WHERE id = 1");
    const ModelId last = connection.integer("SELECT coalesce(max(id), -1) FROM models");
    for (std::int64_t number = 0; number * kScanBlockModels <= last; ++number) {
        write_scan_block(connection, number, revision, {});
    }
}

Result<StoredScan> Store::scan(const std::optional<CollectionState>& known) {
    return impl_->locked([&]() -> Result<StoredScan> {
        SQLite::Transaction transaction(impl_->database());
        const auto state = read_state(*impl_);
        if (!state) return state.error();
        StoredScan scan;
        scan.state = *state;
        scan.whole = !known || known->replacements != state->replacements;
        Query blocks(impl_->statement(
            scan.whole
                ? "SELECT block, models FROM scan_blocks ORDER BY block"
                : "SELECT block, models FROM scan_blocks WHERE revision > ? ORDER BY block"));
        if (!scan.whole) blocks.bind(known->models);
        while (blocks.step()) {
            auto decoded = decode_scan_block(blocks.blob(1));
            if (!decoded) {
                return Error{decoded.error().code, impl_->path.string() + ": block " +
                                                       std::to_string(blocks.integer(0)) + ": " +
                                                       decoded.error().message};
            }
            scan.blocks.push_back(
                {blocks.integer(0), std::make_shared<const ScanBlock>(*std::move(decoded))});
        }
        if (scan.whole || known->statistics != state->statistics) {
            Query statistics(impl_->statement("SELECT revision, statistics FROM statistics"));
            if (statistics.step()) {
                auto decoded = decode_statistics(statistics.blob(1));
                if (!decoded) return decoded.error();
                scan.statistics = StoredStatistics{*std::move(decoded), statistics.integer(0)};
            }
        }
        scan.outer_paths = read_outer_paths(*impl_->connection);
        return scan;
    });
}

}  // namespace ossuary::index
