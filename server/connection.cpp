#include "server/connection.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>

namespace ossuary::server {
namespace {

struct Endpoint {
    std::string address;
    int port = 0;
};

Endpoint endpoint(const sockaddr_storage& storage) {
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (storage.ss_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, &storage, sizeof v4);
        inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
        return {text.data(), ntohs(v4.sin_port)};
    }
    if (storage.ss_family == AF_INET6) {
        sockaddr_in6 v6{};
        std::memcpy(&v6, &storage, sizeof v6);
        inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
        return {text.data(), ntohs(v6.sin6_port)};
    }
    return {};
}

using NameOf = int (*)(int, sockaddr*, socklen_t*);

Endpoint endpoint_of(int socket, NameOf name_of) {
    sockaddr_storage storage{};
    socklen_t size = sizeof storage;
    if (name_of(socket, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return {};
    return endpoint(storage);
}

/// Milliseconds until the deadline as poll wants them, rounded up.
int poll_timeout(Clock::time_point deadline) {
    const auto now = Clock::now();
    if (deadline <= now) return 0;
    if (deadline == Clock::time_point::max()) return -1;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - now).count();
    return static_cast<int>(std::min<long long>(left, 1 << 30));
}

/// True when the socket is ready for `events` before the deadline.
bool wait_for(int socket, short events, Clock::time_point deadline) {
    while (true) {
        pollfd entry{socket, events, 0};
        const int ready = poll(&entry, 1, poll_timeout(deadline));
        if (ready > 0) return true;
        if (ready == 0 && Clock::now() >= deadline) return false;
        if (ready < 0 && errno != EINTR) return false;
    }
}

}  // namespace

Connection::Connection(int socket) : socket_(socket) {
    const int flags = fcntl(socket_, F_GETFL, 0);
    fcntl(socket_, F_SETFL, flags | O_NONBLOCK);
    const int on = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

Connection::~Connection() { close(socket_); }

Connection::Head Connection::read_head(std::size_t max_bytes, Clock::time_point deadline) {
    constexpr std::string_view kEnd = "\r\n\r\n";
    std::size_t searched = 0;
    while (true) {
        const std::size_t end = buffer_.find(kEnd, searched < 3 ? 0 : searched - 3);
        if (end != std::string::npos && end + kEnd.size() <= max_bytes) {
            head_size_ = end + kEnd.size();
            return Head::kComplete;
        }
        if (buffer_.size() >= max_bytes) return Head::kTooLarge;
        searched = buffer_.size();
        std::array<char, 8192> chunk;
        const long got = receive(chunk.data(), chunk.size(), deadline);
        if (got < 0) return timed_out_ ? Head::kTimeout : Head::kClosed;
        if (got == 0) return buffer_.empty() ? Head::kClosed : Head::kPartial;
        buffer_.append(chunk.data(), static_cast<std::size_t>(got));
    }
}

std::string_view Connection::head() const {
    return std::string_view(buffer_).substr(0, head_size_ == 0 ? buffer_.size() : head_size_);
}

void Connection::consume_head() {
    buffer_.erase(0, head_size_);
    head_size_ = 0;
}

bool Connection::wait_readable(Clock::time_point deadline, int wake) const {
    while (true) {
        std::array<pollfd, 2> entries = {pollfd{socket_, POLLIN, 0}, pollfd{wake, POLLIN, 0}};
        const int ready = poll(entries.data(), entries.size(), poll_timeout(deadline));
        if (ready > 0) return entries[0].revents != 0;
        if (ready == 0 && Clock::now() >= deadline) return false;
        if (ready < 0 && errno != EINTR) return false;
    }
}

long Connection::receive(char* data, std::size_t size, Clock::time_point deadline) {
    while (true) {
        const ssize_t got = recv(socket_, data, size, 0);
        if (got >= 0) {
            bytes_read_ += static_cast<std::size_t>(got);
            return got;
        }
        if (errno == EINTR) continue;
        if (errno != EAGAIN && errno != EWOULDBLOCK) return -1;
        if (!wait_for(socket_, POLLIN, deadline)) {
            timed_out_ = true;
            return -1;
        }
    }
}

long Connection::read(char* data, std::size_t size) {
    assert(head_size_ == 0);
    if (!buffer_.empty()) {
        const std::size_t count = std::min(size, buffer_.size());
        std::copy_n(buffer_.begin(), count, data);
        buffer_.erase(0, count);
        return static_cast<long>(count);
    }
    if (Clock::now() >= read_deadline_) {
        timed_out_ = true;
        return -1;
    }
    return receive(data, size, read_deadline_);
}

long Connection::write(const char* data, std::size_t size) {
    std::size_t written = 0;
    while (written < size) {
        const ssize_t count = send(socket_, data + written, size - written, MSG_NOSIGNAL);
        if (count >= 0) {
            written += static_cast<std::size_t>(count);
            bytes_written_ += static_cast<std::size_t>(count);
            if (Clock::now() < write_deadline_) continue;
        } else if (errno == EINTR) {
            continue;
        } else if (errno != EAGAIN && errno != EWOULDBLOCK) {
            return -1;
        }
        if (written < size && !wait_for(socket_, POLLOUT, write_deadline_)) {
            timed_out_ = true;
            return -1;
        }
    }
    return static_cast<long>(size);
}

void Connection::linger(std::chrono::milliseconds patience) {
    shutdown(socket_, SHUT_WR);
    const auto deadline = Clock::now() + patience;
    std::array<char, 65536> sink;
    while (Clock::now() < deadline) {
        if (receive(sink.data(), sink.size(), deadline) <= 0) return;
    }
}

std::string Connection::remote_address() const { return endpoint_of(socket_, getpeername).address; }
int Connection::remote_port() const { return endpoint_of(socket_, getpeername).port; }
std::string Connection::local_address() const { return endpoint_of(socket_, getsockname).address; }
int Connection::local_port() const { return endpoint_of(socket_, getsockname).port; }

}  // namespace ossuary::server
