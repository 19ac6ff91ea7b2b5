#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ossuary::test {

/// An answer as it came over the wire.
struct RawAnswer {
    int status = 0;  ///< 0 when the connection ended without one
    std::vector<std::pair<std::string, std::string>> headers;
    std::string body;

    /// Empty where absent.
    [[nodiscard]] std::string header(std::string_view name) const;
    [[nodiscard]] std::size_t count(std::string_view name) const;
};

/// A socket that sends whatever bytes it is told to, well-formed or not.
class RawClient {
public:
    explicit RawClient(int port);
    ~RawClient();
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    /// Sends all, or as much as the peer takes before it closes.
    void send(std::string_view bytes);
    /// Reads one answer; `head_only` for answers to HEAD, which have no body. Interim answers (1xx)
    /// are counted and skipped.
    RawAnswer receive(bool head_only = false);
    /// Whether the peer closes the connection within the time.
    bool closed_within(std::chrono::milliseconds time);
    /// Whether something has arrived that was not received yet, or the end.
    [[nodiscard]] bool has_arrived() const;
    [[nodiscard]] int interim_answers() const { return interim_; }

private:
    bool fill();

    int socket_ = -1;
    std::string buffer_;
    int interim_ = 0;
};

/// One request on a connection of its own.
RawAnswer ask(int port, std::string_view bytes, bool head_only = false);

/// "GET path" with a Host header and further header lines, each ending in CR LF.
std::string get(std::string_view path, std::string_view headers = {});
std::string request(std::string_view method, std::string_view path, std::string_view headers = {});
/// "POST path" with a Content-Length.
std::string post(std::string_view path, std::string_view body, std::string_view headers = {});

}  // namespace ossuary::test
