#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace ossuary::server {

using Clock = std::chrono::steady_clock;

/// One accepted socket, read and written with absolute deadlines, so that a peer which sends or
/// takes a byte now and then cannot hold a thread for ever. Owns the descriptor.
class Connection {
public:
    explicit Connection(int socket);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    enum class Head {
        kComplete,  ///< `head()` ends with the empty line
        kClosed,    ///< the peer closed before it sent anything
        kPartial,   ///< the peer closed within the header
        kTimeout,
        kTooLarge,
    };
    /// Reads up to and including the empty line; what follows is kept for `read`.
    Head read_head(std::size_t max_bytes, Clock::time_point deadline);
    [[nodiscard]] std::string_view head() const;

    /// True as soon as there is something to read (also the peer's end), false at the deadline or
    /// when `wake`, another descriptor, becomes readable.
    [[nodiscard]] bool wait_readable(Clock::time_point deadline, int wake) const;
    /// Whether bytes of a next request are here already.
    [[nodiscard]] bool has_buffered() const { return !buffer_.empty(); }
    /// Forgets the head that `read_head` gave.
    void consume_head();

    /// Bytes read; 0 at the peer's end, -1 at the deadline or on an error (`timed_out` tells).
    long read(char* data, std::size_t size);
    /// Writes all or fails: `size`, or -1.
    long write(const char* data, std::size_t size);

    void set_read_deadline(Clock::time_point deadline) { read_deadline_ = deadline; }
    void set_write_deadline(Clock::time_point deadline) { write_deadline_ = deadline; }
    [[nodiscard]] bool timed_out() const { return timed_out_; }
    [[nodiscard]] std::size_t bytes_read() const { return bytes_read_; }
    [[nodiscard]] std::size_t bytes_written() const { return bytes_written_; }

    /// Ends our side and swallows what the peer still sends, for at most `patience`, so that it
    /// gets to read the answer to a request that was refused half way.
    void linger(std::chrono::milliseconds patience);

    [[nodiscard]] int socket() const { return socket_; }
    [[nodiscard]] std::string remote_address() const;
    [[nodiscard]] int remote_port() const;
    [[nodiscard]] std::string local_address() const;
    [[nodiscard]] int local_port() const;

private:
    long receive(char* data, std::size_t size, Clock::time_point deadline);

    int socket_;
    std::string buffer_;  ///< received and not yet consumed
    std::size_t head_size_ = 0;
    Clock::time_point read_deadline_ = Clock::time_point::max();
    Clock::time_point write_deadline_ = Clock::time_point::max();
    bool timed_out_ = false;
    std::size_t bytes_read_ = 0;
    std::size_t bytes_written_ = 0;
};

}  // namespace ossuary::server
