#include "tests/index/sample_index.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "engine/mesh/write_mesh.h"
#include "index/codec.h"
#include "index/content_hash.h"
#include "index/migrations.h"
#include "index/scan_block.h"
#include "index/store_checksum.h"
#include "index/store_scan.h"
#include "tests/support/shapes.h"

namespace ossuary::test {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write_file(const fs::path& path, std::string_view bytes) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    EXPECT_TRUE(file) << path;
}

namespace {

/// Numbers that follow from the seed alone on every platform.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : engine_(seed) {}
    double real() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
    float small() { return static_cast<float>(real() * 2.0 - 1.0); }
    std::uint32_t below(std::uint32_t bound) {
        return static_cast<std::uint32_t>(engine_() % bound);
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace

index::NewModel sample_model(std::uint64_t seed, const std::string& path) {
    Numbers numbers(seed);
    index::NewModel model;
    index::ModelSummary& summary = model.summary;
    summary.path = path;
    summary.name = path.empty() ? "upload" + std::to_string(seed) : fs::path(path).stem().string();
    summary.class_name = seed % 3 == 0 ? "" : "class" + std::to_string(seed % 3);
    summary.content_hash = index::content_hash("model " + std::to_string(seed));
    summary.vertices = 3 + numbers.below(1000);
    summary.faces = 1 + numbers.below(1000);
    summary.bounds = Box3(Vec3(-numbers.real(), -1.0, 0.1), Vec3(1.0, numbers.real(), 1.0 / 3.0));
    summary.surface_area = numbers.real();
    summary.warnings = {{"degenerate_faces", seed, "\"quoted\" \xC3\xA9"}};

    const std::uint32_t nodes = 2 + numbers.below(6);
    for (std::uint32_t i = 0; i < nodes; ++i) {
        skeleton::SkeletonGraph::Node node;
        node.position = Vec3(numbers.real(), numbers.real(), -numbers.real());
        node.radius = numbers.real();
        node.significance = numbers.real();
        model.skeleton.nodes.push_back(node);
        model.descriptor.skeleton.nodes.push_back(
            {{numbers.small(), numbers.small(), numbers.small()},
             0.1F + numbers.small() * 0.05F,
             numbers.small() * 0.1F + 0.2F});
    }
    for (std::uint32_t b = 1; b < nodes; ++b) {
        skeleton::SkeletonGraph::Branch branch;
        branch.a = numbers.below(b);
        branch.b = b;
        matching::SkeletonDescriptor::Branch coded{branch.a, b, "", {}, {}, 0.0F};
        const std::uint32_t points = 2 + numbers.below(5);
        for (std::uint32_t i = 0; i < points; ++i) {
            branch.points.emplace_back(numbers.real(), numbers.real(), numbers.real());
            branch.radii.push_back(numbers.real());
            for (int axis = 0; axis < 3; ++axis) coded.points.push_back(numbers.small());
            coded.radii.push_back(0.1F + 0.05F * numbers.small());
            coded.chain_code += static_cast<char>('0' + numbers.below(5));
        }
        coded.length = 0.5F + numbers.small() * 0.1F;
        model.skeleton.branches.push_back(std::move(branch));
        model.descriptor.skeleton.branches.push_back(std::move(coded));
    }
    model.descriptor.skeleton.solid_volume = 0.03F;
    model.descriptor.skeleton.limb_volume = 0.02F;
    skeleton::update_degrees(model.skeleton);
    matching::derive_matching_data(model.descriptor.skeleton);
    for (const auto& [name, size] : {std::pair<const char*, int>{"d2", 8}, {"heat", 5}}) {
        descriptor::GlobalDescriptor global{name, {}};
        for (int i = 0; i < size; ++i) {
            global.values.push_back(static_cast<std::uint8_t>(numbers.below(256)));
        }
        model.descriptor.globals.push_back(std::move(global));
    }
    for (int i = 0; i < 16; ++i) model.descriptor.signature.push_back(numbers.small());
    model.preview.positions = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, numbers.small(), 0.0F};
    model.preview.triangles = {0, 1, 2, 0, 2, 1, 2, 1, 0};
    model.preview.colours = {index::PreviewColours::Of::kVertices, {255, 0, 0, 0, 255, 0, 9, 8, 7}};
    model.summary.frame = {1e-3, index::Up::kZ};
    model.segments.emplace();
    model.segments->parts = {{2, numbers.real(), 0, {1}}, {1, numbers.real(), -1, {0}}};
    model.segments->labels = {0, 1, 0};
    model.features.area = numbers.real();
    model.features.features.points = {Vec3(0.5, 0, 1), Vec3(0, -0.25, 2)};
    model.features.features.normals = {Vec3(1, 0, 0), Vec3(0, -1, 0)};
    model.features.features.radii = {0.5, 0.75, 1.0};
    model.features.features.features.resize(6);
    for (auto& feature : model.features.features.features) {
        for (auto& value : feature.values) {
            value = static_cast<std::uint8_t>(9 * numbers.below(16));
        }
    }
    model.thumbnail = {
        0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', static_cast<std::uint8_t>(seed)};
    return model;
}

ranking::RetrievalReport sample_report(std::uint64_t seed) {
    Numbers numbers(seed);
    const auto metrics = [&] {
        return ranking::RetrievalMetrics{numbers.real(), numbers.real(), numbers.real(),
                                         numbers.real(), numbers.real(), numbers.real()};
    };
    ranking::RetrievalReport report;
    report.models = 7;
    report.classes = 2;
    report.mean = metrics();
    report.macro_mean = metrics();
    for (int i = 1; i <= 20; ++i) report.precision_recall.push_back({0.05 * i, numbers.real()});
    report.per_class = {{"a, \"b\" <c>", 4, metrics()}, {"d", 3, metrics()}};
    report.confusion = {0.75, 0.25, 0.0, 1.0};
    for (std::size_t i = 0; i < 7; ++i) report.per_query.push_back({i, metrics()});
    return report;
}

void write_sample_meshes(const fs::path& folder, int count) {
    fs::create_directories(folder);
    for (int i = 0; i < count; ++i) {
        mesh::TriangleMesh mesh;
        std::string kind;
        switch (i % 3) {
            case 0:
                kind = "box";
                mesh = box_mesh(Vec3::Zero(), Vec3(1.0, 1.2, 4.0));
                break;
            case 1:
                kind = "tree";
                mesh = capsule_tree_mesh();
                break;
            default:
                kind = "torus";
                mesh = torus_mesh(3.0, 1.0, 24, 12);
        }
        // No two of a kind are alike.
        const Vec3 stretch(1.0, 1.0 + 0.04 * i, 1.0 - 0.02 * i);
        mesh = transformed(mesh, stretch.asDiagonal());
        const std::string number = (i < 10 ? "0" : "") + std::to_string(i);
        const auto written = mesh::write_off(mesh, folder / (number + "_" + kind + ".off"));
        EXPECT_TRUE(written);
    }
}

namespace {

/// A block as if all of its models had changed at once.
std::string without_revisions_in(std::string_view blob) {
    auto block = index::decode_scan_block(blob);
    if (!block) return block.error().message;
    std::fill(block->changed_at.begin(), block->changed_at.end(), 0);
    return index::encode_scan_block(*block);
}

}  // namespace

std::string index_text(const fs::path& path) {
    SQLite::Database database(path.string(), SQLite::OPEN_READONLY);
    std::string text;
    for (const std::string table :
         {"parameters", "state", "models", "signatures", "descriptors", "skeletons", "branches",
          "previews", "segments", "thumbnails", "orientations", "file_frames", "failures",
          "statistics", "evaluations", "uploads", "upload_pieces", "scan_blocks"}) {
        text += "== " + table + "\n";
        SQLite::Statement rows(database, "SELECT * FROM " + table + " ORDER BY 1, 2");
        while (rows.executeStep()) {
            for (int column = 0; column < rows.getColumnCount(); ++column) {
                const std::string name = rows.getColumnName(column);
                if (name.ends_with("_at") || name == "checksum") continue;
                const SQLite::Column value = rows.getColumn(column);
                text += name + "=";
                if (value.isBlob()) {
                    const std::string_view blob(static_cast<const char*>(value.getBlob()),
                                                static_cast<std::size_t>(value.getBytes()));
                    text += index::content_hash(table == "scan_blocks" ? without_revisions_in(blob)
                                                                       : std::string(blob));
                } else {
                    text += value.getString();
                }
                text += ' ';
            }
            text += '\n';
        }
    }
    return text;
}

std::string without_revisions(const std::string& text) {
    return std::regex_replace(text, std::regex("revision=[0-9]+"), "revision=");
}

void execute_sql(const fs::path& path, const std::string& sql) {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, 5000);
    database.exec(sql);
}

namespace {

void seal_all(SQLite::Database& database) {
    index::add_checksum_function(database);
    for (const index::ChecksummedTable& table :
         index::checksummed_tables(index::schema_version())) {
        database.exec("UPDATE " + std::string(table.table) + " SET checksum = NULL");
    }
    index::seal_unsealed_rows(database, index::schema_version());
}

}  // namespace

void leave_log_behind(const fs::path& path, const std::string& sql) {
    // Not a child that is killed: a copy of what such a one would leave, taken while it is there.
    {
        SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, 5000);
        database.exec("PRAGMA wal_autocheckpoint = 0");
        database.exec(sql);
        seal_all(database);
        fs::copy_file(path, path.string() + ".copy");
        fs::copy_file(path.string() + "-wal", path.string() + ".copy-wal");
    }
    fs::rename(path.string() + ".copy", path);
    fs::rename(path.string() + ".copy-wal", path.string() + "-wal");
}

void seal_again(const fs::path& path) {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, 5000);
    seal_all(database);
}

void make_database(const fs::path& path, const std::string& sql) {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec(sql);
}

void make_old_index(const fs::path& path, int version, const index::NewModel& model) {
    make_database(
        path,
        "PRAGMA journal_mode = WAL; PRAGMA application_id = 0x4F535359; PRAGMA user_version = " +
            std::to_string(version));
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
    for (const index::Migration& migration : index::migrations()) {
        if (migration.version <= version) database.exec(std::string(migration.sql));
    }
    const bool with_segments = version >= 3;
    const int pipeline =
        with_segments ? index::kPipelineVersion : index::kFirstPipelineWithSegments - 1;
    database.exec(
        "INSERT INTO parameters (name, value) VALUES ('resolution', '96'), "
        "('thinning', 'anchored'), ('pipeline', '" +
        std::to_string(pipeline) + "'); UPDATE state SET revision = 1;");
    const std::size_t nodes = model.skeleton.nodes.size();
    const std::size_t branches = model.skeleton.branches.size();
    SQLite::Statement row(
        database,
        "INSERT INTO models (id, path, name, content_hash, nodes, branches, vertices, faces, "
        "min_x, "
        "min_y, min_z, max_x, max_y, max_z, surface_area, warnings, indexed_at, revision) VALUES "
        "(1, ?, ?, ?, ?, ?, 3, 1, 0, 0, 0, 1, 1, 1, 2.5, '[]', '2026-01-01T00:00:00Z', 1)");
    row.bind(1, model.summary.path);
    row.bind(2, model.summary.name);
    row.bind(3, model.summary.content_hash);
    row.bind(4, static_cast<std::int64_t>(nodes));
    row.bind(5, static_cast<std::int64_t>(branches));
    row.exec();
    const auto insert = [&](const std::string& sql, const std::vector<std::string>& blobs) {
        SQLite::Statement statement(database, sql);
        for (std::size_t i = 0; i < blobs.size(); ++i) {
            statement.bind(static_cast<int>(i) + 1, blobs[i].data(),
                           static_cast<int>(blobs[i].size()));
        }
        statement.exec();
    };
    insert("INSERT INTO signatures VALUES (1, ?)",
           {index::encode_signature(model.descriptor.signature)});
    insert("INSERT INTO descriptors VALUES (1, ?, ?)",
           {index::encode_descriptor(model.descriptor.skeleton),
            index::encode_globals(model.descriptor.globals)});
    insert("INSERT INTO skeletons VALUES (1, ?)", {index::encode_skeleton(model.skeleton)});
    insert("INSERT INTO previews VALUES (1, ?)", {index::encode_preview(model.preview)});
    if (version >= index::kFirstVersionWithOrientations) {
        database.exec("INSERT INTO orientations VALUES (1, 'z', 'person')");
    }
    if (with_segments) {
        insert("INSERT INTO segments VALUES (1, ?)", {index::encode_segments(*model.segments)});
    }
    for (std::size_t i = 0; i < branches; ++i) {
        const skeleton::SkeletonGraph::Branch& branch = model.skeleton.branches[i];
        SQLite::Statement statement(database, "INSERT INTO branches VALUES (1, ?, ?, ?, ?, ?)");
        statement.bind(1, static_cast<std::int64_t>(i));
        statement.bind(2, branch.a);
        statement.bind(3, branch.b);
        statement.bind(4, branch.length());
        statement.bind(5, model.descriptor.skeleton.branches[i].chain_code);
        statement.exec();
    }
    if (version >= index::kFirstVersionWithUploads) {
        index::add_checksum_function(database);
        index::seal_unsealed_rows(database, version);
    }
    if (version >= index::kFirstVersionWithScan) {
        index::Connection connection(path, SQLite::OPEN_READWRITE);
        index::fill_scan_blocks(connection);
    }
}

std::string schema_text(const fs::path& path) {
    SQLite::Database database(path.string(), SQLite::OPEN_READONLY);
    std::string text;
    SQLite::Statement rows(database, "SELECT name, sql FROM sqlite_schema ORDER BY name");
    while (rows.executeStep()) {
        text += rows.getColumn(0).getString() + ": " + rows.getColumn(1).getString() + "\n";
    }
    return text;
}

struct HeldWriteLock::Connection {
    explicit Connection(const fs::path& path)
        : database(path.string(), SQLite::OPEN_READWRITE),
          transaction(database, SQLite::TransactionBehavior::IMMEDIATE) {}
    SQLite::Database database;
    SQLite::Transaction transaction;
};

HeldWriteLock::HeldWriteLock(const fs::path& path)
    : connection_(std::make_unique<Connection>(path)) {}

HeldWriteLock::~HeldWriteLock() = default;

void expect_sound(index::Store& store) {
    const auto report = store.verify();
    ASSERT_TRUE(report) << report.error().message;
    for (const index::Finding& finding : report->findings) {
        ADD_FAILURE() << finding.subject << ": " << finding.message;
    }
}

}  // namespace ossuary::test
