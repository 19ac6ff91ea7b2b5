#include <malloc.h>
#include <systemd/sd-daemon.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <future>
#include <initializer_list>
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

int exit_status_for(ossuary::ErrorCode code) {
    return ossuary::index::is_unusable_index(code) ? kNotAnIndex : kFailed;
}

/// Sent by the server's thread when it ends by itself.
constexpr int kEnded = SIGUSR1;

sigset_t set_of(std::initializer_list<int> signals) {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : signals) sigaddset(&set, signal);
    return set;
}

/// The signals that end a server, also that of a terminal which is closed.
sigset_t ending_signals() { return set_of({SIGINT, SIGTERM, SIGHUP}); }

/// Blocks them for this thread and those that it will start, so that `sigwait` gets them. SIGPIPE
/// is no news: writes report it themselves.
void block_signals() {
    const sigset_t ending = ending_signals();
    const sigset_t ended = set_of({kEnded});
    pthread_sigmask(SIG_BLOCK, &ending, nullptr);
    pthread_sigmask(SIG_BLOCK, &ended, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

/// From here on such a signal ends the process at once, for whoever does not want to wait.
void unblock_signals() {
    const sigset_t ending = ending_signals();
    pthread_sigmask(SIG_UNBLOCK, &ending, nullptr);
}

/// glibc gives many threads a heap of their own each and hands little of those back.
void hold_memory_down() { mallopt(M_ARENA_MAX, 2); }

std::string address(const ossuary::server::ServerOptions& options, int port) {
    const bool v6 = options.host.find(':') != std::string::npos;
    return "http://" + (v6 ? "[" + options.host + "]" : options.host) + ":" + std::to_string(port);
}

/// Says what is wrong; the exit status.
int failed(const ossuary::Error& error) {
    std::cerr << "ossuary-server: " << to_string(error.code) << ": " << error.message << '\n';
    return exit_status_for(error.code);
}

/// Runs until a signal, then lets what is under way finish, then asks what is left to stop.
int serve(ossuary::server::Server& server, const ossuary::server::ServerOptions& options) {
    std::promise<ossuary::Result<void>> outcome;
    std::future<ossuary::Result<void>> ended = outcome.get_future();
    std::thread runner([&] {
        outcome.set_value(server.run());
        kill(getpid(), kEnded);
    });
    std::cout << "listening on " << address(options, server.port()) << std::endl;
    const sigset_t awaited = set_of({SIGINT, SIGTERM, SIGHUP, kEnded});
    int received = 0;
    sd_notify(0, "READY=1");
    sigwait(&awaited, &received);
    sd_notify(0, "STOPPING=1");
    server.stop();
    unblock_signals();
    if (ended.wait_for(options.drain_timeout) != std::future_status::ready) server.cancel();
    runner.join();
    const auto result = ended.get();
    if (result) return 0;
    failed(result.error());
    return kFailed;
}

int check_config(const ossuary::server::ServerOptions& options) {
    std::cout << options.effective;
    const auto checked = ossuary::server::Server::check(options);
    if (!checked) return failed(checked.error());
    std::cout << "# index, gallery and key can be used\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace ossuary::server;
    ParsedOptions parsed = parse_options(argc, argv);
    if (!parsed.run) return parsed.exit_status;
    hold_memory_down();
    ServerOptions& options = parsed.options;
    if (options.web.empty()) {
        std::error_code ignored;
        options.web = find_web_folder(std::filesystem::read_symlink("/proc/self/exe", ignored));
    }
    if (options.check_config) return check_config(options);
    block_signals();
    auto server = Server::open(options);
    if (!server) return failed(server.error());
    if (!is_loopback(options.host)) {
        std::cerr << "ossuary-server: warning: " << options.host
                  << " can be reached from other machines\n";
    }
    return serve(**server, options);
}
