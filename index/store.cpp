#include "index/store.h"

#include <charconv>

#include "index/migrations.h"
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

Result<std::unique_ptr<Connection>> open_or_create_connection(const fs::path& path,
                                                              const IndexParameters& parameters) {
    auto kind = inspect_file(path);
    if (!kind) return kind.error();
    if (*kind == FileKind::kIndex) {
        auto connection = open_connection(path, Access::kReadWrite);
        if (connection || connection.error().code != ErrorCode::kIndexForeign) return connection;
        // Opening undid a creation that was cut short, if that was all there was.
        const Error error = connection.error();
        kind = inspect_file(path);
        if (!kind || *kind != FileKind::kEmpty) return error;
    }
    const fs::path folder = fs::absolute(path).parent_path();
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        return {ErrorCode::kIndexIo,
                path.string() + ": cannot be made, there is no folder " + folder.string()};
    }
    return create_connection(path, parameters);
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
    return CollectionState{query.integer(0), query.integer(1)};
}

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store> Store::open(const fs::path& path, Access access) {
    auto impl = std::make_unique<Impl>();
    impl->path = path;
    auto connection = open_connection(path, access);
    if (!connection) return connection.error();
    impl->connection = *std::move(connection);
    const auto parameters = guarded(path, [&] { return read_parameters(*impl->connection, path); });
    if (!parameters) return parameters.error();
    impl->parameters = *parameters;
    return Store(std::move(impl));
}

Result<Store> Store::create_or_open(const fs::path& path, const IndexParameters& parameters) {
    {
        const auto connection = open_or_create_connection(path, parameters);
        if (!connection) return connection.error();
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

const IndexParameters& Store::parameters() const { return impl_->parameters; }

int Store::version() const { return schema_version(); }

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
        impl_->database().setBusyTimeout(milliseconds);
        return {};
    });
}

Result<void> Store::checkpoint() {
    return impl_->locked([&]() -> Result<void> {
        impl_->database().exec("PRAGMA wal_checkpoint(TRUNCATE)");
        return {};
    });
}

}  // namespace ossuary::index
