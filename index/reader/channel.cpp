#include "index/reader/channel.h"

#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace ossuary::index {
namespace {

constexpr std::size_t kMaxDescriptors = 2;
using ControlBuffer = std::array<char, CMSG_SPACE(kMaxDescriptors * sizeof(int))>;

Error system_error(const char* what) {
    return {ErrorCode::kInternal,
            std::string(what) + ": " + std::error_code(errno, std::generic_category()).message()};
}

/// Linux takes about 2 GB at a time at most.
constexpr std::size_t kMostAtOnce = 1 << 30;

}  // namespace

OwnedDescriptor::~OwnedDescriptor() {
    if (number_ >= 0) ::close(number_);
}

bool send_packet(int socket, std::string_view bytes, const std::vector<int>& descriptors) {
    iovec part{const_cast<char*>(bytes.data()), bytes.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    alignas(cmsghdr) ControlBuffer control{};
    if (!descriptors.empty()) {
        const std::size_t size = descriptors.size() * sizeof(int);
        message.msg_control = control.data();
        message.msg_controllen = CMSG_SPACE(size);
        cmsghdr* header = CMSG_FIRSTHDR(&message);
        header->cmsg_level = SOL_SOCKET;
        header->cmsg_type = SCM_RIGHTS;
        header->cmsg_len = CMSG_LEN(size);
        std::memcpy(CMSG_DATA(header), descriptors.data(), size);
    }
    ssize_t sent = -1;
    do {
        sent = ::sendmsg(socket, &message, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    return sent == static_cast<ssize_t>(bytes.size());
}

Result<Packet> receive_packet(int socket) {
    Packet packet;
    packet.bytes.resize(kMaxPacket);
    iovec part{packet.bytes.data(), packet.bytes.size()};
    alignas(cmsghdr) ControlBuffer control{};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    ssize_t received = -1;
    do {
        received = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
    } while (received < 0 && errno == EINTR);
    if (received < 0) return system_error("recvmsg");
    packet.bytes.resize(static_cast<std::size_t>(received));
    for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr;
         header = CMSG_NXTHDR(&message, header)) {
        if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
        const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t i = 0; i < count; ++i) {
            int number = -1;
            std::memcpy(&number, CMSG_DATA(header) + i * sizeof(int), sizeof(int));
            packet.descriptors.emplace_back(number);
        }
    }
    return packet;
}

Result<OwnedDescriptor> memory_file(std::string_view contents) {
    OwnedDescriptor file(::memfd_create("ossuary", MFD_CLOEXEC));
    if (!file.is_open()) return system_error("memfd_create");
    if (!write_all(file.get(), contents.data(), contents.size())) return system_error("write");
    return file;
}

bool write_all(int descriptor, const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::write(descriptor, next, std::min(size, kMostAtOnce));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        next += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

bool read_exactly(int descriptor, void* data, std::size_t size, std::uint64_t offset) {
    char* next = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t got =
            ::pread(descriptor, next, std::min(size, kMostAtOnce), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        next += got;
        offset += static_cast<std::uint64_t>(got);
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

}  // namespace ossuary::index
