#pragma once

#include <memory>

#include "engine/core/result.h"
#include "server/options.h"

namespace ossuary::server {

/// The whole server, ready to run.
class Server {
public:
    /// Opens the index and binds the port. Errors: those of Searcher::open, of the administrator's
    /// key, of the gallery's folder when one was named, and of the address.
    static Result<std::unique_ptr<Server>> open(const ServerOptions& options);
    /// Opens all that `open` opens but the port, and lets go of it. Errors: those of `open`.
    static Result<void> check(const ServerOptions& options);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    [[nodiscard]] int port() const;
    /// Serves until `stop`, then answers what is under way.
    Result<void> run();
    /// From any thread, also before `run`. Takes no more connections.
    void stop();
    /// Asks what is under way to end early.
    void cancel();

private:
    struct Parts;
    explicit Server(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace ossuary::server
