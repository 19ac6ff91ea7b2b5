#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/result.h"

namespace ossuary::index {

/// A file descriptor that is closed with its owner.
class OwnedDescriptor {
public:
    OwnedDescriptor() = default;
    explicit OwnedDescriptor(int number) : number_(number) {}
    OwnedDescriptor(OwnedDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    OwnedDescriptor& operator=(OwnedDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    OwnedDescriptor(const OwnedDescriptor&) = delete;
    OwnedDescriptor& operator=(const OwnedDescriptor&) = delete;
    ~OwnedDescriptor();

    [[nodiscard]] int get() const { return number_; }
    [[nodiscard]] bool is_open() const { return number_ >= 0; }

private:
    int number_ = -1;
};

/// A message between the programs and the process that reads for them, with what is handed over.
struct Packet {
    std::string bytes;
    std::vector<OwnedDescriptor> descriptors;
};

/// The longest message; what is longer travels in memory files.
inline constexpr std::size_t kMaxPacket = 64 << 10;

/// Sends a message over a socket that keeps messages apart (SOCK_SEQPACKET); false where the other
/// side has gone.
bool send_packet(int socket, std::string_view bytes, const std::vector<int>& descriptors = {});

/// Waits for a message; an empty one stands for the end of the connection.
/// Errors: internal, with the system's reason.
Result<Packet> receive_packet(int socket);

/// A file in memory that goes with its last descriptor. Errors: internal.
Result<OwnedDescriptor> memory_file(std::string_view contents = {});

/// Writes all of it where the descriptor stands. False where it does not fit or cannot be done.
bool write_all(int descriptor, const void* data, std::size_t size);

/// Reads exactly so many bytes from a place in a file; false where there are fewer.
bool read_exactly(int descriptor, void* data, std::size_t size, std::uint64_t offset);

}  // namespace ossuary::index
