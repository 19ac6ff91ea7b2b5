#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "server/server.h"
#include "tests/server/raw_client.h"
#include "tests/support/temporary_folder.h"

namespace ossuary::test {

/// Built models as OFF text by file stem; their classes are the stems without the last letter:
/// balla, ballb, ringa, ringb, treea, treeb.
struct BuiltModel {
    std::string name;
    std::string class_name;
    std::string off;
};
const std::vector<BuiltModel>& built_models();

/// An index of the built models at a low resolution. Made once a process; each call copies it into
/// `folder`.
std::filesystem::path copy_of_built_index(const std::filesystem::path& folder);

/// Adds one more model to an index, as `ossuary index` would while a server has it open.
void index_model(const std::filesystem::path& index, const std::string& name,
                 const std::string& off);

/// A whole server in this process, on a port of its own.
class TestServer {
public:
    using Change = std::function<void(server::ServerOptions&)>;
    explicit TestServer(const std::filesystem::path& index, const Change& change = {});
    ~TestServer();
    TestServer(const TestServer&) = delete;
    TestServer& operator=(const TestServer&) = delete;

    [[nodiscard]] int port() const { return server_->port(); }
    RawAnswer ask(std::string_view bytes, bool head_only = false) const {
        return test::ask(port(), bytes, head_only);
    }
    /// The JSON of an answer that must have this status.
    nlohmann::json json(std::string_view bytes, int status = 200) const;
    /// The `code` of a problem that must have this status.
    std::string code(std::string_view bytes, int status) const;
    void stop();

private:
    std::unique_ptr<server::Server> server_;
    std::thread runner_;
};

}  // namespace ossuary::test
