#include "server/connection.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace ossuary::server {
namespace {

std::string address_text(const sockaddr_storage& storage) {
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (storage.ss_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, &storage, sizeof v4);
        inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
    } else if (storage.ss_family == AF_INET6) {
        sockaddr_in6 v6{};
        std::memcpy(&v6, &storage, sizeof v6);
        inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
    }
    return text.data();
}

/// So that a peer which sends fast does not hold the thread.
constexpr int kChunksATime = 16;

bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK; }

}  // namespace

Connection::Connection(int socket) : socket_(socket) {
    const int flags = fcntl(socket_, F_GETFL, 0);
    fcntl(socket_, F_SETFL, flags | O_NONBLOCK);
    const int on = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

Connection::~Connection() { close(socket_); }

Connection::Io Connection::receive(char* data, std::size_t size, std::size_t& got) {
    while (true) {
        const ssize_t count = recv(socket_, data, size, 0);
        if (count > 0) {
            got = static_cast<std::size_t>(count);
            return Io::kDone;
        }
        if (count < 0 && errno == EINTR) continue;
        return count < 0 && would_wait() ? Io::kWait : Io::kEnded;
    }
}

Connection::Io Connection::fill(std::size_t most) {
    std::array<char, 16384> chunk;
    std::size_t got = 0;
    const Io outcome =
        receive(chunk.data(), std::min(chunk.size(), most - std::min(most, buffer_.size())), got);
    if (outcome == Io::kDone) buffer_.append(chunk.data(), got);
    return outcome;
}

Connection::Io Connection::read_into(std::string& out, std::size_t size) {
    const std::size_t held = std::min(buffer_.size(), size - out.size());
    out.append(buffer_, 0, held);
    buffer_.erase(0, held);
    std::array<char, 65536> chunk;
    for (int i = 0; i < kChunksATime && out.size() < size; ++i) {
        std::size_t got = 0;
        const std::size_t wanted = std::min(chunk.size(), size - out.size());
        if (const Io outcome = receive(chunk.data(), wanted, got); outcome != Io::kDone) {
            return outcome;
        }
        out.append(chunk.data(), got);
    }
    return out.size() == size ? Io::kDone : Io::kWait;
}

Connection::Io Connection::write(std::string_view& rest) {
    while (!rest.empty()) {
        const ssize_t count = send(socket_, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (count >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return would_wait() ? Io::kWait : Io::kEnded;
        }
    }
    return Io::kDone;
}

void Connection::end_output() { shutdown(socket_, SHUT_WR); }

Connection::Io Connection::swallow() {
    buffer_.clear();
    std::array<char, 65536> sink;
    for (int i = 0; i < kChunksATime; ++i) {
        std::size_t got = 0;
        if (const Io outcome = receive(sink.data(), sink.size(), got); outcome != Io::kDone) {
            return outcome;
        }
    }
    return Io::kWait;
}

std::string Connection::remote_address() const {
    sockaddr_storage storage{};
    socklen_t size = sizeof storage;
    if (getpeername(socket_, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return {};
    return address_text(storage);
}

}  // namespace ossuary::server
