#include "tests/server/raw_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ossuary::test {
namespace {

bool same(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    });
}

}  // namespace

std::string RawAnswer::header(std::string_view name) const {
    for (const auto& [key, value] : headers) {
        if (same(key, name)) return value;
    }
    return {};
}

std::size_t RawAnswer::count(std::string_view name) const {
    return static_cast<std::size_t>(
        std::count_if(headers.begin(), headers.end(),
                      [&](const auto& header) { return same(header.first, name); }));
}

RawClient::RawClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        throw std::runtime_error("cannot connect to the server under test");
    }
}

RawClient::~RawClient() { ::close(socket_); }

void RawClient::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) return;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

bool RawClient::fill() {
    constexpr int kPatienceMs = 30'000;
    pollfd entry{socket_, POLLIN, 0};
    if (poll(&entry, 1, kPatienceMs) <= 0) return false;
    std::array<char, 65536> chunk;
    const ssize_t got = recv(socket_, chunk.data(), chunk.size(), 0);
    if (got <= 0) return false;
    buffer_.append(chunk.data(), static_cast<std::size_t>(got));
    return true;
}

RawAnswer RawClient::receive(bool head_only) {
    std::size_t end = 0;
    while ((end = buffer_.find("\r\n\r\n")) == std::string::npos) {
        if (!fill()) return {};
    }
    RawAnswer answer;
    std::string_view head = std::string_view(buffer_).substr(0, end + 2);
    answer.status = std::stoi(std::string(head.substr(9, 3)));
    head.remove_prefix(head.find("\r\n") + 2);
    while (!head.empty()) {
        const std::string_view line = head.substr(0, head.find("\r\n"));
        const std::size_t colon = line.find(": ");
        answer.headers.emplace_back(line.substr(0, colon), line.substr(colon + 2));
        head.remove_prefix(line.size() + 2);
    }
    buffer_.erase(0, end + 4);
    if (answer.status < 200) {
        ++interim_;
        return receive(head_only);
    }
    const std::string length = answer.header("Content-Length");
    const std::size_t size = head_only || length.empty() ? 0 : std::stoul(length);
    while (buffer_.size() < size) {
        if (!fill()) return {};
    }
    answer.body = buffer_.substr(0, size);
    buffer_.erase(0, size);
    return answer;
}

bool RawClient::closed_within(std::chrono::milliseconds time) {
    const auto deadline = std::chrono::steady_clock::now() + time;
    std::array<char, 4096> chunk;
    while (std::chrono::steady_clock::now() < deadline) {
        pollfd entry{socket_, POLLIN, 0};
        if (poll(&entry, 1, 20) > 0 && recv(socket_, chunk.data(), chunk.size(), 0) <= 0) {
            return true;
        }
    }
    return false;
}

bool RawClient::has_arrived() const {
    pollfd entry{socket_, POLLIN, 0};
    return poll(&entry, 1, 0) > 0;
}

RawAnswer ask(int port, std::string_view bytes, bool head_only) {
    RawClient client(port);
    client.send(bytes);
    return client.receive(head_only);
}

std::string request(std::string_view method, std::string_view path, std::string_view headers) {
    return std::string(method) + " " + std::string(path) + " HTTP/1.1\r\nHost: localhost\r\n" +
           std::string(headers) + "\r\n";
}

std::string get(std::string_view path, std::string_view headers) {
    return request("GET", path, headers);
}

std::string post(std::string_view path, std::string_view body, std::string_view headers) {
    return request(
               "POST", path,
               std::string(headers) + "Content-Length: " + std::to_string(body.size()) + "\r\n") +
           std::string(body);
}

}  // namespace ossuary::test
