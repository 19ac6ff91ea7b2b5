#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "index/reader/channel.h"
#include "index/reader/protocol.h"

namespace ossuary::index {

/// What one file may cost the process that reads it.
struct ReaderLimits {
    std::uint64_t memory_bytes = 2ull << 30;
    std::chrono::seconds processor_time{60};
    std::chrono::milliseconds time{180'000};  ///< of the clock
};

/// Gives the files that a model refers to. Errors: gltf_buffer, with the reason.
using GiveFile = std::function<Result<OwnedDescriptor>(std::string_view name)>;

/// One `ossuary-read` and the way to it. It ends with its owner, however that ends.
class ReaderProcess {
public:
    /// Starts it and waits until it has confined itself. Errors: reader_unavailable.
    static Result<std::unique_ptr<ReaderProcess>> start(const std::filesystem::path& program,
                                                        const ReaderLimits& limits);
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;
    ~ReaderProcess();

    /// Reads one model. Messages do not name the file.
    /// Errors: reader_time, reader_memory, reader_crashed where the process was ended or ended
    /// itself; cancelled; those of the format.
    Result<mesh::ReadMeshResult> read(const ReadRequest& request, std::string_view bytes,
                                      const GiveFile& give, const std::stop_token& stop);

    /// The files in a ZIP archive, in its order; messages do not name it.
    /// Errors: archive_invalid; those of the process.
    Result<std::vector<ArchiveMember>> list(int archive, const std::stop_token& stop);

    /// One of them, unpacked. Errors: archive_invalid, archive_member, file_too_large; those of the
    /// process.
    Result<WholeFile> unpack(int archive, const UnpackRequest& request,
                             const std::stop_token& stop);

    /// Whether it can be asked for another model: it lives, and has neither read many nor a large
    /// one (libraries leak, and memory in pieces is as good as none).
    [[nodiscard]] bool is_usable() const;

private:
    ReaderProcess(pid_t process, OwnedDescriptor socket, const ReaderLimits& limits)
        : process_(process), socket_(std::move(socket)), limits_(limits) {}

    using Deadline = std::chrono::steady_clock::time_point;

    Result<void> wait_until_ready();
    Result<Packet> next_message(Deadline deadline, const std::stop_token& stop);
    Result<std::string> ask(std::string_view request, int file, int answer, const GiveFile& give,
                            const std::stop_token& stop);
    bool hand_over(std::string_view name, const GiveFile& give);
    bool limit_processor_time();
    void kill();
    /// Its status; ends it where it does not end by itself soon.
    int wait_for_end();
    /// Why it ended, as far as the system says; waits for its end.
    Error cause_of_death();

    pid_t process_;
    OwnedDescriptor socket_;
    ReaderLimits limits_;
    bool usable_ = true;
    bool waited_for_ = false;
    int read_ = 0;  ///< files
};

}  // namespace ossuary::index
