#include <gtest/gtest.h>

#include "tests/server/http_fixture.h"

namespace ossuary::server {
namespace {

TEST_F(Http, AnswersSeveralRequestsOnOneConnection) {
    RawClient client(port_);
    for (int i = 0; i < 5; ++i) {
        client.send(post("/echo", "hello"));
        const RawAnswer answer = client.receive();
        ASSERT_EQ(answer.status, 200);
        EXPECT_EQ(nlohmann::json::parse(answer.body)["body"], "hello");
        EXPECT_FALSE(answer.header("Date").empty());
        EXPECT_EQ(answer.header("Connection"), "");
    }
}

TEST_F(Http, AnswersPipelinedRequestsInOrder) {
    RawClient client(port_);
    client.send(get("/1") + post("/2", "two") + get("/3"));
    for (const char* path : {"/1", "/2", "/3"}) {
        const RawAnswer answer = client.receive();
        ASSERT_EQ(answer.status, 200);
        EXPECT_EQ(nlohmann::json::parse(answer.body)["path"], path);
    }
}

TEST_F(Http, SendsNoBodyToHead) {
    RawClient client(port_);
    client.send(test::request("HEAD", "/x") + get("/y"));
    const RawAnswer head = client.receive(true);
    EXPECT_EQ(head.status, 200);
    EXPECT_NE(head.header("Content-Length"), "0");
    const RawAnswer next = client.receive();
    EXPECT_EQ(nlohmann::json::parse(next.body)["path"], "/y");
}

TEST_F(Http, RefusesTransferEncodings) {
    EXPECT_EQ(code_for(test::request("POST", "/", "Transfer-Encoding: chunked\r\n") +
                           "5\r\nhello\r\n0\r\n\r\n",
                       411),
              "length_required");
    EXPECT_EQ(handler_.handled, 0);
    EXPECT_TRUE(alive());
}

TEST_F(Http, RefusesContentEncodings) {
    EXPECT_EQ(code_for(post("/", "x", "Content-Encoding: gzip\r\n"), 415),
              "content_encoding_unsupported");
    EXPECT_EQ(handler_.handled, 0);
}

TEST_F(Http, RefusesLengthsThatAreRepeatedOrContradicted) {
    EXPECT_EQ(code_for(post("/", "x", "Content-Length: 1\r\n"), 400), "ambiguous_length");
    EXPECT_EQ(code_for(post("/", "x", "Content-Length: 2\r\n"), 400), "ambiguous_length");
    EXPECT_EQ(code_for(post("/", "x", "Transfer-Encoding: chunked\r\n"), 400), "ambiguous_length");
    EXPECT_EQ(code_for(test::request("POST", "/", "Content-Length: 1, 1\r\n") + "x", 400),
              "ambiguous_length");
    EXPECT_EQ(handler_.handled, 0);
}

TEST_F(Http, DoesNotTakeARefusedRequestsBodyForTheNextRequest) {
    RawClient client(port_);
    client.send(post("/refused", "a body that nobody reads") + get("/next"));
    EXPECT_EQ(client.receive().status, 404);
    EXPECT_TRUE(client.closed_within(5s));
    EXPECT_EQ(handler_.handled, 0);
}

TEST_F(Http, RefusesControlCharacters) {
    using namespace std::string_literals;
    EXPECT_EQ(code_for(get("/", "X-A: a\x01z\r\n"), 400), "control_characters");
    EXPECT_EQ(code_for(get("/", "X-A: a\0z\r\n"s), 400), "control_characters");
    EXPECT_EQ(code_for(get("/x%0d%0aSet-Cookie:%20a=b"), 400), "control_characters");
    EXPECT_EQ(code_for(get("/x?name=%0d%0aSet-Cookie:%20a=b"), 400), "control_characters");
    EXPECT_EQ(handler_.handled, 0);
}

TEST_F(Http, RefusesTooManyFields) {
    std::string fields;
    for (int i = 0; i < 100; ++i) fields.append("X-").append(std::to_string(i)).append(": a\r\n");
    EXPECT_EQ(code_for(get("/", fields), 431), "too_many_fields");
}

TEST_F(Http, RefusesLargeHeadersWithoutReadingThemToTheEnd) {
    EXPECT_EQ(code_for(get("/", "X-A: " + std::string(40'000, 'a') + "\r\n"), 431),
              "fields_too_large");
    const std::string unfinished =
        "GET / HTTP/1.1\r\nHost: localhost\r\nX-A: " + std::string(40'000, 'a');
    EXPECT_EQ(code_for(unfinished, 431), "fields_too_large");
}

TEST_F(Http, RefusesLongAddresses) {
    EXPECT_EQ(code_for(get("/" + std::string(5'000, 'a')), 414), "uri_too_long");
    EXPECT_EQ(code_for(get("/" + std::string(40'000, 'a')), 414), "uri_too_long");
}

TEST_F(Http, RefusesGarbage) {
    using namespace std::string_literals;
    EXPECT_EQ(code_for("\x16\x03\x01\x02\0\x01\0\r\n\r\n"s, 400), "malformed_request");
    EXPECT_EQ(code_for("\r\n\r\n", 400), "malformed_request");
    EXPECT_EQ(code_for("GET / HTTP/3.0\r\n\r\n", 505), "version_unsupported");
    EXPECT_EQ(code_for(get("/", "Expect: a pony\r\n"), 417), "expectation_failed");
    EXPECT_TRUE(alive());
}

TEST_F(Http, TakesTheRemoteAddressFromTheSocket) {
    const RawAnswer answer = ask(port_, get("/", "X-Forwarded-For: 10.9.8.7\r\n"));
    EXPECT_EQ(nlohmann::json::parse(answer.body)["remote"], "127.0.0.1");
}

TEST_F(Http, IgnoresRanges) {
    const RawAnswer answer = ask(port_, get("/", "Range: bytes=0-3\r\n"));
    EXPECT_EQ(answer.status, 200);
    EXPECT_TRUE(nlohmann::json::accept(answer.body));
}

TEST_F(Http, RefusesLargeBodiesBeforeTheyAreSent) {
    RawClient client(port_);
    client.send(test::request("POST", "/", "Content-Length: 100001\r\nExpect: 100-continue\r\n"));
    const RawAnswer answer = client.receive();
    EXPECT_EQ(answer.status, 413);
    EXPECT_EQ(client.interim_answers(), 0);
    EXPECT_EQ(handler_.handled, 0);
}

TEST_F(Http, LetsAClientThatSendsTooMuchReadTheRefusal) {
    EXPECT_EQ(code_for(post("/", std::string(5'000'000, 'x')), 413), "payload_too_large");
    EXPECT_EQ(code_for(post("/refused", std::string(90'000, 'x')), 404), "route_not_found");
    EXPECT_TRUE(alive());
}

TEST_F(Http, AsksForABodyThatWaitsToBeAskedFor) {
    RawClient client(port_);
    client.send(test::request("POST", "/", "Content-Length: 5\r\nExpect: 100-continue\r\n"));
    std::jthread later([&] {
        std::this_thread::sleep_for(100ms);
        client.send("hello");
    });
    const RawAnswer answer = client.receive();
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(client.interim_answers(), 1);
    EXPECT_EQ(nlohmann::json::parse(answer.body)["body"], "hello");
}

TEST_F(Http, RefusesABodyWhereNoneBelongs) {
    const std::string body = "Content-Length: 3\r\n";
    EXPECT_EQ(code_for(test::request("GET", "/", body) + "abc", 400), "body_unexpected");
    EXPECT_EQ(code_for(test::request("DELETE", "/", body) + "abc", 400), "body_unexpected");
}

TEST_F(Http, KeepsTheTextOfExceptionsToItself) {
    const RawAnswer answer = ask(port_, get("/throws"));
    EXPECT_EQ(answer.status, 500);
    std::string all = answer.body;
    for (const auto& [name, value] : answer.headers) all += name + value;
    EXPECT_EQ(all.find("secret"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(answer.body)["code"], "internal");
    EXPECT_TRUE(alive());
}

TEST_F(Http, TellsTheLogTheCauseOfEach500) {
    const RawAnswer answer = ask(port_, get("/throws"));
    const Exchange told = exchange();
    EXPECT_EQ(told.status, 500);
    EXPECT_EQ(told.id, answer.header("X-Request-Id"));
    EXPECT_NE(told.cause.find("secret text"), std::string::npos);
    ask(port_, get("/throws-a-number"));
    EXPECT_EQ(exchange(2).status, 500);
    EXPECT_FALSE(exchange(2).cause.empty());
}

TEST_F(Http, AnswersWhatTheMemoryDoesNotSufficeFor) {
    const RawAnswer answer = ask(port_, get("/no-memory"));
    EXPECT_EQ(answer.status, 503);
    EXPECT_EQ(nlohmann::json::parse(answer.body)["code"], "out_of_memory");
    EXPECT_FALSE(exchange().cause.empty());
    EXPECT_TRUE(alive());
}

TEST_F(Http, RefusesABodyThatTheMemoryDoesNotSufficeFor) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    GTEST_SKIP() << "clang's sanitizers end the program where memory runs out";
#endif
#endif
    HttpOptions options = quick();
    options.max_body = options.max_bodies = std::size_t{1} << 60;
    restart(options);
    RawClient client(port_);
    client.send(test::request("POST", "/",
                              "Content-Length: " + std::to_string(std::size_t{1} << 59) + "\r\n") +
                "the beginning");
    const RawAnswer answer = client.receive();
    EXPECT_EQ(answer.status, 503);
    EXPECT_EQ(answer.header("Connection"), "close");
    EXPECT_EQ(nlohmann::json::parse(answer.body)["code"], "out_of_memory");
    EXPECT_EQ(ask(port_, post("/", "small")).status, 200);
}

TEST_F(Http, EndsRequestsThatDoNotArrive) {
    HttpOptions options = quick();
    options.head_timeout = 200ms;
    options.request_timeout = 300ms;
    restart(options);
    EXPECT_EQ(code_for("GET / HTT", 408), "request_timeout");
    EXPECT_EQ(code_for(test::request("POST", "/", "Content-Length: 5\r\n") + "ab", 408),
              "request_timeout");
    // A byte now and then does not buy more time.
    RawClient client(port_);
    const auto start = std::chrono::steady_clock::now();
    client.send("GET / HTTP/1.1\r\n");
    while (!client.closed_within(20ms) && std::chrono::steady_clock::now() - start < 5s) {
        client.send("A: b\r\n");
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, 2s);
}

TEST_F(Http, StopsWorkWhenItsTimeIsUp) {
    HttpOptions options = quick();
    options.request_timeout = 300ms;
    restart(options);
    EXPECT_EQ(ask(port_, get("/slow")).body, "stopped");
}

TEST_F(Http, StopsWorkWhenTheClientLeaves) {
    {
        RawClient client(port_);
        client.send(get("/slow"));
        while (!handler_.entered) std::this_thread::yield();
    }
    for (int i = 0; i < 100 && handler_.exchanges().empty(); ++i) {
        std::this_thread::sleep_for(20ms);
    }
    ASSERT_EQ(handler_.exchanges().size(), 1u);
    EXPECT_LT(handler_.exchanges()[0].milliseconds, 5'000.0);
}

TEST_F(Http, FinishesWhatIsUnderWayWhenStopped) {
    RawClient client(port_);
    client.send(get("/slow") + get("/pipelined"));
    ASSERT_TRUE(eventually([&] { return handler_.entered.load(); }));
    RawClient idle(port_);
    RawClient arriving(port_);
    arriving.send("GET / HTTP/1.1\r\n");
    server_->stop();
    EXPECT_TRUE(idle.closed_within(5s));
    arriving.send("Host: localhost\r\n\r\n");
    const RawAnswer arrived = arriving.receive();
    EXPECT_EQ(arrived.status, 200);
    EXPECT_EQ(arrived.header("Connection"), "close");
    handler_.released = true;
    server_->cancel();
    const RawAnswer answer = client.receive();
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.header("Connection"), "close");
    runner_.join();
    server_.reset();
    EXPECT_ANY_THROW(RawClient{port_});
}

TEST_F(Http, RefusesAPortThatIsTaken) {
    HttpServer second(quick(), handler_);
    const auto port = second.bind("127.0.0.1", port_);
    ASSERT_FALSE(port);
    EXPECT_EQ(port.error().code, ErrorCode::kInvalidArgument);
}

TEST_F(Http, CompressesLargeAnswersForThoseWhoTakeIt) {
    const RawAnswer packed = ask(port_, get("/large", "Accept-Encoding: br, gzip\r\n"));
    EXPECT_EQ(packed.header("Content-Encoding"), "gzip");
    EXPECT_LT(packed.body.size(), 10'000u);
    EXPECT_EQ(packed.header("Vary"), "Accept-Encoding");
    EXPECT_EQ(ask(port_, get("/large")).header("Content-Encoding"), "");
    const RawAnswer small = ask(port_, get("/", "Accept-Encoding: gzip\r\n"));
    EXPECT_EQ(small.header("Content-Encoding"), "");
}

TEST_F(Http, UsesARequestIdOfTheClientsOnlyWhenItIsPlain) {
    const auto id = [&](const std::string& wished) {
        return ask(port_, get("/", "X-Request-Id: " + wished + "\r\n")).header("X-Request-Id");
    };
    EXPECT_EQ(id("abc-1.2_3"), "abc-1.2_3");
    EXPECT_NE(id("a b"), "a b");
    EXPECT_NE(id(std::string(65, 'a')), std::string(65, 'a'));
}

TEST_F(Http, ReportsEveryRequestOnce) {
    ask(port_, post("/a", "hello"));
    ask(port_, get("/", "A : b\r\n"));
    for (int i = 0; i < 100 && handler_.exchanges().size() < 2; ++i) {
        std::this_thread::sleep_for(10ms);
    }
    const auto log = handler_.exchanges();
    ASSERT_EQ(log.size(), 2u);
    EXPECT_EQ(log[0].status, 200);
    EXPECT_EQ(log[0].target, "/a");
    EXPECT_GE(log[0].bytes_in, 5u);
    EXPECT_EQ(log[1].status, 400);
    EXPECT_EQ(log[1].code, "malformed_request");
}

}  // namespace
}  // namespace ossuary::server
