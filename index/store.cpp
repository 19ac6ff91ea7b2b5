#include "index/store.h"

#include <charconv>

#include "index/migrations.h"
#include "index/store_file.h"
#include "index/store_impl.h"

namespace ossuary::index {

namespace {

namespace fs = std::filesystem;

std::optional<int> parse_positive(const std::string& text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value <= 0) return {};
    return value;
}

std::string in_words(const IndexParameters& parameters) {
    return "resolution " + std::to_string(parameters.resolution) + ", thinning " +
           std::string(to_string(parameters.thinning)) + ", pipeline version " +
           std::to_string(parameters.pipeline);
}

}  // namespace

bool is_unusable_index(ErrorCode code) {
    switch (code) {
        case ErrorCode::kIndexNotFound:
        case ErrorCode::kIndexForeign:
        case ErrorCode::kIndexNewer:
        case ErrorCode::kIndexCorrupt:
        case ErrorCode::kIndexParameters:
            return true;
        default:
            return false;
    }
}

Result<IndexParameters> read_parameters(Connection& connection, const fs::path& path) {
    const auto damaged = [&path](const std::string& what) {
        return Error{ErrorCode::kIndexCorrupt, path.string() + ": parameters: " + what};
    };
    IndexParameters parameters;
    int found = 0;
    Query query(connection.statement("SELECT name, value FROM parameters ORDER BY name"));
    while (query.step()) {
        const std::string name = query.text(0);
        const std::string value = query.text(1);
        if (name == "thinning") {
            const auto method = skeleton::parse_thinning_method(value);
            if (!method) return damaged("thinning \"" + value + "\" is not known");
            parameters.thinning = *method;
        } else if (name == "resolution" || name == "pipeline") {
            const auto number = parse_positive(value);
            if (!number) return damaged(name + " \"" + value + "\" is not a positive number");
            (name == "resolution" ? parameters.resolution : parameters.pipeline) = *number;
        } else {
            return damaged("\"" + name + "\" is not known");
        }
        ++found;
    }
    if (found != 3) return damaged(std::to_string(found) + " found, expected 3");
    return parameters;
}

Result<CollectionState> read_state(Store::Impl& impl) {
    Query query(
        impl.statement("SELECT revision, coalesce((SELECT revision FROM statistics WHERE id = 1), "
                       "-1) FROM state WHERE id = 1"));
    if (!query.step()) return {ErrorCode::kIndexCorrupt, impl.path.string() + ": no revision"};
    return CollectionState{query.integer(0), query.integer(1), impl.replacements()};
}

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store::Impl::Impl(const fs::path& index, Access how)
    : path(index), access(how), file(IndexFile::at(index)) {}

Store::Impl::~Impl() {
    const ExclusiveLock alone(file->gate());
    file->close(connection);
}

Result<void> Store::Impl::open() {
    const ExclusiveLock alone(file->gate());
    file->let_go_of_replaced();
    if (connection) return {};
    const bool again = version > 0;
    if (again && !follows) {
        return {ErrorCode::kIndexReplaced,
                path.string() + ": was removed or replaced by another file while it was open"};
    }
    if (auto opened = file->open(connection, access); !opened) return opened;
    const auto found = read_parameters(*connection, path);
    if (!found || (again && *found != parameters)) {
        file->close(connection);
        if (!found) return found.error();
        return {ErrorCode::kIndexReplaced, path.string() + ": was replaced by an index of " +
                                               in_words(*found) + ", the one before had " +
                                               in_words(parameters) + "; start anew to use it"};
    }
    connection->set_busy_timeout(busy_timeout_ms);
    if (!again) {
        parameters = *found;
        version = static_cast<int>(connection->integer("PRAGMA user_version"));
    }
    return {};
}

Result<void> Store::Impl::commit(SQLite::Transaction& transaction) {
    transaction.commit();
    file->is_in_use();
    if (file->stands()) return {};
    return was_replaced();
}

Result<Store> Store::open(const fs::path& path, Access access) {
    auto impl = std::make_unique<Impl>(path, access);
    if (const auto opened = impl->locked([]() -> Result<void> { return {}; }); !opened) {
        return opened.error();
    }
    return Store(std::move(impl));
}

Result<Store> Store::create_or_open(const fs::path& path, const IndexParameters& parameters) {
    {
        const auto file = IndexFile::at(path);
        const ExclusiveLock alone(file->gate());
        file->let_go_of_replaced();
        if (const auto made = make_index(path, parameters); !made) return made.error();
    }
    auto store = open(path, Access::kReadWrite);
    if (!store) return store;
    if (store->parameters() != parameters) {
        return {ErrorCode::kIndexParameters,
                path.string() + ": was built with " + in_words(store->parameters()) +
                    ", asked for " + in_words(parameters) +
                    "; models of one index are described alike, so index into a new file"};
    }
    return store;
}

const fs::path& Store::path() const { return impl_->path; }

bool Store::owns(const fs::path& file) const {
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
        std::error_code none_there;
        if (fs::equivalent(impl_->path.string() + ending, file, none_there)) return true;
    }
    return false;
}

const IndexParameters& Store::parameters() const { return impl_->parameters; }

int Store::version() const { return impl_->version; }

void Store::follow_replacements() { impl_->follows = true; }

bool Store::follows_replacements() const { return impl_->follows; }

Result<Revision> Store::revision() {
    const auto state = collection_state();
    if (!state) return state.error();
    return state->models;
}

Result<CollectionState> Store::collection_state() {
    return impl_->locked([&]() -> Result<CollectionState> { return read_state(*impl_); });
}

Result<void> Store::set_busy_timeout(int milliseconds) {
    return impl_->locked([&]() -> Result<void> {
        impl_->busy_timeout_ms = milliseconds;
        impl_->connection->set_busy_timeout(milliseconds);
        return {};
    });
}

Result<void> Store::checkpoint() {
    return impl_->locked([&]() -> Result<void> {
        impl_->connection->fold_log(0);
        return {};
    });
}

}  // namespace ossuary::index
