#include "index/reader_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <string>
#include <system_error>
#include <thread>

namespace ossuary::index {
namespace {

constexpr int kChannel = 3;
constexpr std::chrono::milliseconds kBetweenLooks{20};
constexpr std::chrono::seconds kLongestStart{30};
/// That one process reads.
constexpr int kMostFiles = 200;

Error unavailable(const std::filesystem::path& program, const std::string& reason) {
    return {ErrorCode::kReaderUnavailable, program.string() + ": " + reason};
}

/// How a new process is to begin: descriptor 3 is its socket, the others lead nowhere; it hears no
/// signals of the terminal, and those that its parent holds back.
class SpawnPlan {
public:
    explicit SpawnPlan(int socket) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, 1, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, 2, "/dev/null", O_WRONLY, 0);
        // Also takes the mark off it that would close it.
        posix_spawn_file_actions_adddup2(&actions_, socket, kChannel);
        posix_spawn_file_actions_addclosefrom_np(&actions_, kChannel + 1);
        posix_spawnattr_init(&attributes_);
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        sigset_t all;
        sigfillset(&all);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(
            &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }

    /// @returns the system's reason where it cannot be started, else 0
    int run(const std::filesystem::path& program, std::string memory, pid_t& process) const {
        std::string name = program.string();
        std::array<char*, 3> arguments = {name.data(), memory.data(), nullptr};
        std::array<char*, 1> environment = {nullptr};
        return posix_spawn(&process, program.c_str(), &actions_, &attributes_, arguments.data(),
                           environment.data());
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// Archives refer to no others.
Result<OwnedDescriptor> no_files(std::string_view) {
    return {ErrorCode::kArchiveInvalid, "expected no other files, found one asked for"};
}

}  // namespace

Result<std::unique_ptr<ReaderProcess>> ReaderProcess::start(const std::filesystem::path& program,
                                                            const ReaderLimits& limits) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return unavailable(program, std::generic_category().message(errno));
    }
    OwnedDescriptor ours(ends[0]);
    OwnedDescriptor theirs(ends[1]);
    // Descriptor 3 itself would keep its mark when it is put in its own place.
    if (theirs.get() == kChannel) {
        theirs = OwnedDescriptor(::fcntl(theirs.get(), F_DUPFD_CLOEXEC, kChannel + 1));
    }
    pid_t process = -1;
    const int reason =
        SpawnPlan(theirs.get()).run(program, std::to_string(limits.memory_bytes), process);
    if (reason != 0) return unavailable(program, std::generic_category().message(reason));
    theirs = OwnedDescriptor();
    std::unique_ptr<ReaderProcess> started(new ReaderProcess(process, std::move(ours), limits));
    if (auto ready = started->wait_until_ready(); !ready) {
        return unavailable(program, ready.error().message);
    }
    return started;
}

ReaderProcess::~ReaderProcess() {
    kill();
    wait_for_end();
}

bool ReaderProcess::is_usable() const {
    // Whatever it says unasked, most likely that it has ended.
    pollfd waiting{socket_.get(), POLLIN, 0};
    return usable_ && read_ < kMostFiles && ::poll(&waiting, 1, 0) == 0;
}

void ReaderProcess::kill() {
    usable_ = false;
    if (!waited_for_) ::kill(process_, SIGKILL);
}

Result<void> ReaderProcess::wait_until_ready() {
    const auto first = next_message(std::chrono::steady_clock::now() + kLongestStart, {});
    if (!first) return first.error();
    if (kind_of(first->bytes) != MessageKind::kReady || first->bytes.size() > 1) {
        return {ErrorCode::kReaderUnavailable,
                "the reader does not start: " + std::string(text_of(first->bytes))};
    }
    return {};
}

Result<Packet> ReaderProcess::next_message(Deadline deadline, const std::stop_token& stop) {
    while (true) {
        // Looked at before every message: one that sends them without end gets no further.
        if (stop.stop_requested()) {
            kill();
            return {ErrorCode::kCancelled, "reading was cancelled"};
        }
        if (std::chrono::steady_clock::now() >= deadline) {
            kill();
            return {ErrorCode::kReaderTime, "expected a file that is read within " +
                                                std::to_string(limits_.time.count()) +
                                                " ms, found one that takes longer"};
        }
        pollfd waiting{socket_.get(), POLLIN, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kBetweenLooks.count()));
        if (ready > 0) break;
        if (ready < 0 && errno != EINTR) {
            kill();
            return {ErrorCode::kInternal, std::generic_category().message(errno)};
        }
    }
    auto packet = receive_packet(socket_.get());
    if (!packet || packet->bytes.empty()) return cause_of_death();
    return packet;
}

int ReaderProcess::wait_for_end() {
    constexpr int kLooks = 100;
    int status = 0;
    for (int look = 0; !waited_for_; ++look) {
        // One that has let go of its socket and lives on is not waited for.
        if (look == kLooks) kill();
        const pid_t ended = ::waitpid(process_, &status, look < kLooks ? WNOHANG : 0);
        waited_for_ = ended == process_ || (ended < 0 && errno != EINTR);
        if (!waited_for_) std::this_thread::sleep_for(kBetweenLooks);
    }
    return status;
}

Error ReaderProcess::cause_of_death() {
    usable_ = false;
    const int status = wait_for_end();
    if (!WIFSIGNALED(status)) {
        return {ErrorCode::kReaderCrashed, "the reader ended in the middle of the file"};
    }
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU) {
        return {ErrorCode::kReaderTime, "expected a file that is read within " +
                                            std::to_string(limits_.processor_time.count()) +
                                            " s of processor time, found one that takes longer"};
    }
    if (signal == SIGXFSZ) {
        return {ErrorCode::kReaderMemory, "expected a smaller mesh, found one beyond all limits"};
    }
    const char* name = sigabbrev_np(signal);
    return {ErrorCode::kReaderCrashed, std::string("the reader was ended by the file, with SIG") +
                                           (name == nullptr ? "?" : name)};
}

bool ReaderProcess::limit_processor_time() {
    clockid_t clock{};
    timespec used{};
    if (clock_getcpuclockid(process_, &clock) != 0 || clock_gettime(clock, &used) != 0)
        return false;
    rlimit limits{};
    if (::prlimit(process_, RLIMIT_CPU, nullptr, &limits) != 0) return false;
    // The soft limit alone, which can be raised for the next file.
    limits.rlim_cur =
        static_cast<rlim_t>(used.tv_sec) + static_cast<rlim_t>(limits_.processor_time.count());
    return ::prlimit(process_, RLIMIT_CPU, &limits, nullptr) == 0;
}

bool ReaderProcess::hand_over(std::string_view name, const GiveFile& give) {
    const auto given = give(name);
    if (!given) {
        return send_packet(socket_.get(),
                           text_message(MessageKind::kRefuse, given.error().message));
    }
    return send_packet(socket_.get(), text_message(MessageKind::kGive, ""), {given->get()});
}

/// The message that answers a request; faults as errors.
Result<std::string> ReaderProcess::ask(std::string_view request, int file, int answer,
                                       const GiveFile& give, const std::stop_token& stop) {
    if (!limit_processor_time() || !send_packet(socket_.get(), request, {file, answer})) {
        return cause_of_death();
    }
    const Deadline deadline = std::chrono::steady_clock::now() + limits_.time;
    while (true) {
        auto message = next_message(deadline, stop);
        if (!message) return message.error();
        switch (kind_of(message->bytes)) {
            case MessageKind::kNeed:
                if (!hand_over(text_of(message->bytes), give)) return cause_of_death();
                break;
            case MessageKind::kMesh:
            case MessageKind::kMembers:
            case MessageKind::kUnpacked:
                return std::move(message->bytes);
            default: {
                Error error = decode_fault(message->bytes);
                usable_ = error.code != ErrorCode::kReaderMemory &&
                          error.code != ErrorCode::kReaderCrashed;
                return error;
            }
        }
    }
}

Result<mesh::ReadMeshResult> ReaderProcess::read(const ReadRequest& request, std::string_view bytes,
                                                 const GiveFile& give,
                                                 const std::stop_token& stop) {
    constexpr std::size_t kLargeFile = 16 << 20;
    read_ += bytes.size() < kLargeFile ? 1 : kMostFiles;
    const auto file = memory_file(bytes);
    if (!file) return file.error();
    const auto answer = memory_file();
    if (!answer) return answer.error();
    const auto message = ask(encode_request(request), file->get(), answer->get(), give, stop);
    if (!message) return message.error();
    return read_answer(*message, answer->get(), request.caps);
}

Result<std::vector<ArchiveMember>> ReaderProcess::list(int archive, const std::stop_token& stop) {
    const auto answer = memory_file();
    if (!answer) return answer.error();
    const auto message =
        ask(text_message(MessageKind::kList, ""), archive, answer->get(), no_files, stop);
    if (!message) return message.error();
    return read_members(*message, answer->get());
}

Result<WholeFile> ReaderProcess::unpack(int archive, const UnpackRequest& request,
                                        const std::stop_token& stop) {
    const auto answer = memory_file();
    if (!answer) return answer.error();
    const auto message = ask(encode_unpack(request), archive, answer->get(), no_files, stop);
    if (!message) return message.error();
    return read_unpacked(*message, answer->get(), request.max_bytes);
}

}  // namespace ossuary::index
