#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ossuary::server {

/// A name with its value, in the order in which the client sent them.
struct Field {
    std::string name;
    std::string value;
};
using Fields = std::vector<Field>;

/// True where two header names are the same (ASCII letters in either case).
[[nodiscard]] bool same_name(std::string_view a, std::string_view b);

/// The value of the first field of that name, or nullptr.
[[nodiscard]] const std::string* find_field(const Fields& fields, std::string_view name);

/// A request's line and header, checked and decoded by `check_head`; the body is yet to come.
struct RequestHead {
    std::string method;
    std::string path;   ///< percent-decoded, without control characters
    Fields parameters;  ///< of the query, percent-decoded, without control characters
    Fields headers;
    int minor_version = 1;             ///< of HTTP/1
    std::uint64_t content_length = 0;  ///< 0 where there is no body
    bool keep_alive = true;
    bool expects_continue = false;

    [[nodiscard]] std::string header(std::string_view name) const;  ///< empty where absent
};

/// What a handler gets.
struct Request {
    RequestHead head;
    std::string body;
    std::string id;              ///< of the request, for the log and the answer
    std::string remote_address;  ///< of the socket
    std::string capture;         ///< what the route's `{…}` stands for, empty where it has none
    std::stop_token stop;        ///< asked to stop when time is up or the client has gone
};

/// What a handler answers with.
struct Response {
    int status = 200;
    std::string content_type;
    std::string body;
    Fields headers;
    bool close = false;     ///< end the connection after this answer
    std::string code;       ///< of the problem, for the log; empty for none
    std::string cause;      ///< for the log alone: what went wrong on our side, empty for nothing
    std::string route;      ///< for metrics: the route's pattern, empty for none
    std::string framed_by;  ///< the origins whose pages may show it in a frame, empty for none

    Response& set_header(std::string name, std::string value) {
        headers.push_back({std::move(name), std::move(value)});
        return *this;
    }
};

/// A plain answer of 200 with a body.
[[nodiscard]] Response answer(std::string content_type, std::string body);

}  // namespace ossuary::server
