#include "server/request_head.h"

#include <gtest/gtest.h>

#include <string>

namespace ossuary::server {
namespace {

std::string head(std::string_view line, std::string_view fields = {}) {
    return std::string(line) + "\r\nHost: localhost\r\n" + std::string(fields) + "\r\n";
}

/// The code with which a head is refused, "" when it is taken.
std::string_view code_of(std::string_view raw, const HeadLimits& limits = {}) {
    const auto checked = check_head(raw, limits);
    return checked ? std::string_view() : checked.error().row.code;
}

TEST(RequestHead, DecodesPathAndParameters) {
    const auto checked =
        check_head(head("GET /v1/a%20b?name=caf%C3%A9+x&empty=&flag HTTP/1.1", "X-A:  b \r\n"));
    ASSERT_TRUE(checked);
    EXPECT_EQ(checked->path, "/v1/a b");
    ASSERT_EQ(checked->parameters.size(), 3u);
    EXPECT_EQ(checked->parameters[0].value, "caf\xc3\xa9 x");
    EXPECT_EQ(checked->parameters[1].value, "");
    EXPECT_EQ(checked->parameters[2].name, "flag");
    EXPECT_EQ(checked->header("x-a"), "b");
    EXPECT_TRUE(checked->keep_alive);
}

TEST(RequestHead, TakesTheAuthorityOfAnAbsoluteTargetForTheHost) {
    const auto checked = check_head(head("GET http://example.com/x HTTP/1.1"));
    ASSERT_TRUE(checked);
    EXPECT_EQ(checked->path, "/x");
    EXPECT_EQ(checked->header("Host"), "example.com");
}

TEST(RequestHead, RefusesMalformedRequestLines) {
    for (const char* line :
         {"", "GET", "GET /", "GET  / HTTP/1.1", "G@T / HTTP/1.1", "GET x HTTP/1.1",
          "GET / HTTP/1.1 x", "GET /\x80 HTTP/1.1", "GET /#f HTTP/1.1", "GET / FTP/1.1"}) {
        EXPECT_EQ(code_of(head(line)), "malformed_request") << line;
    }
    EXPECT_EQ(code_of(head("GET / HTTP/2.0")), "version_unsupported");
    EXPECT_EQ(code_of(head("GET /" + std::string(5000, 'a') + " HTTP/1.1")), "uri_too_long");
}

TEST(RequestHead, RefusesWhatAnotherParserMightReadDifferently) {
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A: b\r\n c\r\n")), "malformed_request");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A : b\r\n")), "malformed_request");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", ": b\r\n")), "malformed_request");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A\r\n")), "malformed_request");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A: b\nC: d\r\n")), "malformed_request");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A: b\rC: d\r\n")), "malformed_request");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "Host: other\r\n")), "malformed_request");
    EXPECT_EQ(code_of("GET / HTTP/1.1\r\n\r\n"), "malformed_request");
    EXPECT_EQ(code_of("GET / HTTP/1.0\r\n\r\n"), "");
}

TEST(RequestHead, RefusesControlCharacters) {
    using namespace std::string_literals;
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A: b\0c\r\n"s)), "control_characters");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A: b\x1b[0m\r\n")), "control_characters");
    EXPECT_EQ(code_of(head("GET /?a=%0d%0aSet-Cookie:x HTTP/1.1")), "control_characters");
    EXPECT_EQ(code_of(head("GET /a%00b HTTP/1.1")), "control_characters");
    EXPECT_EQ(code_of(head("GET /?%7f=1 HTTP/1.1")), "control_characters");
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", "A: b\tc\r\n")), "");
}

TEST(RequestHead, RefusesMalformedEscapes) {
    for (const char* path : {"/%", "/%4", "/%zz", "/%ff", "/%c0%af", "/a%2Fb", "/a%5cb", "/?a=%"}) {
        EXPECT_EQ(code_of(head("GET " + std::string(path) + " HTTP/1.1")), "bad_escape") << path;
    }
}

TEST(RequestHead, RefusesAmbiguousBodies) {
    EXPECT_EQ(code_of(head("POST / HTTP/1.1", "Transfer-Encoding: chunked\r\n")),
              "length_required");
    EXPECT_EQ(
        code_of(head("POST / HTTP/1.1", "Transfer-Encoding: chunked\r\nContent-Length: 3\r\n")),
        "ambiguous_length");
    EXPECT_EQ(code_of(head("POST / HTTP/1.1", "Content-Length: 3\r\ncontent-length: 3\r\n")),
              "ambiguous_length");
    for (const char* length : {"", "-1", "+1", "3, 3", "0x3", "3 3", "99999999999999999999"}) {
        EXPECT_EQ(
            code_of(head("POST / HTTP/1.1", "Content-Length: " + std::string(length) + "\r\n")),
            "ambiguous_length")
            << length;
    }
    EXPECT_EQ(code_of(head("POST / HTTP/1.1", "Content-Length: 3\r\nContent-Encoding: gzip\r\n")),
              "content_encoding_unsupported");
}

TEST(RequestHead, TakesAHundredFieldsAndNoMore) {
    std::string fields;
    for (int i = 0; i < 99; ++i) fields += "A: b\r\n";
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", fields)), "");
    fields += "A: b\r\n";
    EXPECT_EQ(code_of(head("GET / HTTP/1.1", fields)), "too_many_fields");
}

TEST(RequestHead, KnowsWhetherTheConnectionGoesOn) {
    const auto keep_alive = [](std::string_view raw) { return check_head(raw)->keep_alive; };
    EXPECT_TRUE(keep_alive(head("GET / HTTP/1.1")));
    EXPECT_FALSE(keep_alive(head("GET / HTTP/1.1", "Connection: x, Close\r\n")));
    EXPECT_FALSE(keep_alive(head("GET / HTTP/1.0")));
    EXPECT_TRUE(keep_alive(head("GET / HTTP/1.0", "Connection: keep-alive\r\n")));
}

TEST(RequestHead, LogsOnlyPrintableText) {
    EXPECT_EQ(loggable_target("GET /\x1b[31m\nx"), "GET /?[31m");
    EXPECT_LE(loggable_target(std::string(10'000, 'x')).size(), 200u);
}

TEST(Utf8, RefusesOverlongFormsSurrogatesAndTruncation) {
    for (const char* good :
         {"", "a", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x92\x80", "\xf4\x8f\xbf\xbf"}) {
        EXPECT_TRUE(is_utf8(good)) << good;
    }
    for (const char* bad : {"\x80", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80",
                            "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xc3\x28"}) {
        EXPECT_FALSE(is_utf8(bad)) << bad;
    }
}

}  // namespace
}  // namespace ossuary::server
