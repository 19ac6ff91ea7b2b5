#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <iostream>
#include <memory>
#include <thread>

#include "index/store.h"
#include "server/application.h"
#include "server/options.h"
#include "server/server.h"

namespace {

constexpr int kFailed = 1;
constexpr int kNotAnIndex = 4;
/// For what has been asked to end to do so.
constexpr auto kLastGrace = std::chrono::seconds(5);

int exit_status_for(ossuary::ErrorCode code) {
    return ossuary::index::is_unusable_index(code) ? kNotAnIndex : kFailed;
}

/// Blocks SIGINT and SIGTERM for this thread and those that it will start, so that `sigwait` gets
/// them. SIGPIPE is no news: writes report it themselves.
sigset_t block_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    return signals;
}

std::string address(const ossuary::server::ServerOptions& options, int port) {
    const bool v6 = options.host.find(':') != std::string::npos;
    return "http://" + (v6 ? "[" + options.host + "]" : options.host) + ":" + std::to_string(port);
}

/// Runs until a signal, then lets what is under way finish, then cancels it, then leaves.
int serve(ossuary::server::Server& server, const ossuary::server::ServerOptions& options,
          const sigset_t& signals) {
    std::promise<ossuary::Result<void>> outcome;
    std::future<ossuary::Result<void>> ended = outcome.get_future();
    std::thread runner([&] {
        outcome.set_value(server.run());
        // Wakes the wait below when the server ends by itself.
        kill(getpid(), SIGTERM);
    });
    std::cout << "listening on " << address(options, server.port()) << std::endl;
    int received = 0;
    sigwait(&signals, &received);
    server.stop();
    if (ended.wait_for(options.drain_timeout) != std::future_status::ready) {
        server.cancel();
        if (ended.wait_for(kLastGrace) != std::future_status::ready) {
            std::cerr << "ossuary-server: requests did not end in time, leaving them\n";
            std::_Exit(kFailed);
        }
    }
    runner.join();
    const auto result = ended.get();
    if (result) return 0;
    std::cerr << "ossuary-server: " << to_string(result.error().code) << ": "
              << result.error().message << '\n';
    return kFailed;
}

/// Ends the background threads. An evaluation cannot be interrupted, but may be abandoned: the
/// index gets its result in one transaction or not at all.
void close(std::unique_ptr<ossuary::server::Server> server, int status) {
    std::promise<void> closed;
    std::future<void> done = closed.get_future();
    std::thread closer([&] {
        server.reset();
        closed.set_value();
    });
    if (done.wait_for(kLastGrace) != std::future_status::ready) {
        std::cerr << "ossuary-server: an evaluation was abandoned\n";
        std::_Exit(status);
    }
    closer.join();
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ossuary::server;
    ParsedOptions parsed = parse_options(argc, argv);
    if (!parsed.run) return parsed.exit_status;
    ServerOptions& options = parsed.options;
    if (options.web.empty()) {
        std::error_code ignored;
        options.web = find_web_folder(std::filesystem::read_symlink("/proc/self/exe", ignored));
    }
    const sigset_t signals = block_signals();
    auto server = Server::open(options);
    if (!server) {
        std::cerr << "ossuary-server: " << to_string(server.error().code) << ": "
                  << server.error().message << '\n';
        return exit_status_for(server.error().code);
    }
    if (!is_loopback(options.host)) {
        std::cerr << "ossuary-server: warning: " << options.host
                  << " can be reached from other machines\n";
    }
    const int status = serve(**server, options, signals);
    close(*std::move(server), status);
    return status;
}
