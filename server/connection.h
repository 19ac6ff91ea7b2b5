#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace ossuary::server {

using Clock = std::chrono::steady_clock;

/// One accepted socket with what has been received on it and not been consumed yet. Nothing here
/// waits: whoever gets `kWait` comes back when the socket is ready. Owns the descriptor.
class Connection {
public:
    explicit Connection(int socket);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    enum class Io {
        kDone,
        kWait,   ///< the socket is not ready
        kEnded,  ///< the peer has ended its side, or the connection is broken
    };

    /// Receives what is there, until `most` bytes are held. Done when there is something new.
    Io fill(std::size_t most);
    [[nodiscard]] std::string_view buffered() const { return buffer_; }
    void consume(std::size_t bytes) { buffer_.erase(0, bytes); }

    /// Moves what is held, then what the socket has, to the end of `out`; done at `size` bytes.
    Io read_into(std::string& out, std::size_t size);
    /// Sends what the socket takes of `rest` and shortens it by that; done when nothing is left.
    Io write(std::string_view& rest);

    /// Ends our side, so that the peer reads the last answer and then the end.
    void end_output();
    /// Throws away what the peer still sends; ended when it has ended its side, too.
    Io swallow();

    [[nodiscard]] int socket() const { return socket_; }
    [[nodiscard]] std::string remote_address() const;

private:
    Io receive(char* data, std::size_t size, std::size_t& got);

    int socket_;
    std::string buffer_;
};

}  // namespace ossuary::server
