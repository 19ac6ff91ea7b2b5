#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ranking/retrieval_metrics.h"
#include "index/indexer.h"
#include "index/model.h"
#include "index/store.h"
#include "tests/support/temporary_folder.h"

/// What several tests of the index build on.
namespace ossuary::test {

std::string read_file(const std::filesystem::path& path);
/// Makes the folder too.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// A made-up model with a valid tree as skeleton; different for every seed, the same for the same.
/// `path` may be empty.
index::NewModel sample_model(std::uint64_t seed, const std::string& path);

ranking::RetrievalReport sample_report(std::uint64_t seed);

/// Writes small meshes of different shapes as OFF files into `folder`: NN_kind.off, `count` of
/// them.
void write_sample_meshes(const std::filesystem::path& folder, int count);

/// Coarse, so that describing a sample mesh takes a fraction of a second.
inline constexpr index::IndexParameters kCoarse{.resolution = 24};

/// Everything that an index holds as text, one line a row, but for times of day. Two indexes with
/// equal text hold the same.
std::string index_text(const std::filesystem::path& path);

/// The same without the revisions, which depend on how the work fell into transactions.
std::string without_revisions(const std::string& text);

/// Runs SQL on the file behind the store's back.
void execute_sql(const std::filesystem::path& path, const std::string& sql);

/// The same by a program that is killed afterwards: what it wrote is in the log.
void leave_log_behind(const std::filesystem::path& path, const std::string& sql);

/// Makes the checksums of all rows right again after `execute_sql`.
void seal_again(const std::filesystem::path& path);

/// A database that is not an index.
void make_database(const std::filesystem::path& path, const std::string& sql);

/// An index as the program of that schema version left it, with one model at revision 1.
void make_old_index(const std::filesystem::path& path, int version, const index::NewModel& model);

/// The SQL of all tables and indexes.
std::string schema_text(const std::filesystem::path& path);

/// Holds an index's write lock, as a long transaction of another process would.
class HeldWriteLock {
public:
    explicit HeldWriteLock(const std::filesystem::path& path);
    ~HeldWriteLock();
    HeldWriteLock(const HeldWriteLock&) = delete;
    HeldWriteLock& operator=(const HeldWriteLock&) = delete;

private:
    struct Connection;
    std::unique_ptr<Connection> connection_;
};

/// Fails the test when `verify` finds anything.
void expect_sound(index::Store& store);

}  // namespace ossuary::test
