#include "server/http.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/server/raw_client.h"

namespace ossuary::server {
namespace {

using test::ask;
using test::get;
using test::post;
using test::RawAnswer;
using test::RawClient;
using namespace std::chrono_literals;

/// Answers with what it got, so that tests see what comes through.
class EchoHandler : public HttpHandler {
public:
    std::optional<Response> admit(const RequestHead& head, const std::string& id) override {
        if (head.path != "/refused") return std::nullopt;
        return to_response(problem(RequestFault::kRouteNotFound, "no"), head.path, id);
    }
    [[nodiscard]] bool is_urgent(const RequestHead& head) const override {
        return head.path == "/urgent";
    }
    Response handle(Request& request) override {
        ++handled;
        if (request.head.path == "/throws") throw std::runtime_error("secret text");
        if (request.head.path == "/throws-a-number") throw 7;
        if (request.head.path == "/no-memory") throw std::bad_alloc();
        if (request.head.path == "/slow") {
            std::unique_lock lock(mutex);
            std::condition_variable_any changed;
            entered = true;
            changed.wait_for(lock, request.stop, 20s, [this] { return released.load(); });
            return answer("text/plain", request.stop.stop_requested() ? "stopped" : "finished");
        }
        nlohmann::json json = {{"method", request.head.method},
                               {"path", request.head.path},
                               {"remote", request.remote_address},
                               {"size", request.body.size()},
                               {"id", request.id}};
        if (request.body.size() < 100) json["body"] = request.body;
        if (request.head.path == "/large") json["filling"] = std::string(100'000, 'x');
        return answer("application/json", json.dump());
    }
    void complete(Response& response, const std::string& id) override {
        response.set_header("X-Request-Id", id);
    }
    void finished(const Exchange& done) override {
        std::lock_guard lock(log_mutex);
        log.push_back(done);
    }
    void refused() override { ++turned_away; }

    std::vector<Exchange> exchanges() {
        std::lock_guard lock(log_mutex);
        return log;
    }

    std::atomic<int> handled = 0;
    std::atomic<int> turned_away = 0;
    std::atomic<bool> entered = false;
    std::atomic<bool> released = false;
    std::mutex mutex;

private:
    std::mutex log_mutex;
    std::vector<Exchange> log;
};

class Http : public testing::Test {
protected:
    static HttpOptions quick() {
        HttpOptions options;
        options.threads = 4;
        options.max_body = 100'000;
        options.max_bodies = 200'000;
        options.linger = 300ms;
        return options;
    }

    void start(const HttpOptions& options) {
        server_ = std::make_unique<HttpServer>(options, handler_);
        const auto port = server_->bind("127.0.0.1", 0);
        ASSERT_TRUE(port) << port.error().message;
        port_ = *port;
        runner_ = std::thread([this] { EXPECT_TRUE(server_->run()); });
    }
    void SetUp() override { start(quick()); }
    void restart(const HttpOptions& options) {
        TearDown();
        handler_.released = false;
        start(options);
    }
    /// Until the handler has entered `/slow`, a connection was refused, …
    template <typename Condition>
    static bool eventually(const Condition& condition) {
        for (int i = 0; i < 2000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
        return condition();
    }
    /// The last exchange, once there are so many.
    Exchange exchange(std::size_t count = 1) {
        EXPECT_TRUE(eventually([&] { return handler_.exchanges().size() >= count; }));
        const auto log = handler_.exchanges();
        return log.empty() ? Exchange{} : log.back();
    }
    void TearDown() override {
        if (server_ == nullptr) return;
        handler_.released = true;
        server_->cancel();
        server_->stop();
        runner_.join();
        server_.reset();
    }

    /// The code of the problem document that the bytes are answered with.
    std::string code_for(std::string_view bytes, int expected_status) {
        const RawAnswer answer = ask(port_, bytes);
        EXPECT_EQ(answer.status, expected_status) << bytes.substr(0, 100);
        EXPECT_EQ(answer.header("Content-Type"), "application/problem+json");
        EXPECT_EQ(answer.count("X-Request-Id"), 1u);
        const auto json = nlohmann::json::parse(answer.body, nullptr, false);
        if (json.is_discarded()) return "(not JSON) " + answer.body;
        EXPECT_EQ(json["status"], expected_status);
        return json["code"];
    }
    bool alive() { return ask(port_, get("/alive")).status == 200; }

    EchoHandler handler_;
    std::unique_ptr<HttpServer> server_;
    int port_ = 0;
    std::thread runner_;
};

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

#if !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)  // which end the process instead
TEST_F(Http, RefusesABodyThatTheMemoryDoesNotSufficeFor) {
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
#endif

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

TEST_F(Http, TurnsRequestsAwayWhenTooManyWait) {
    HttpOptions options = quick();
    options.threads = 1;
    options.max_waiting = 1;
    restart(options);
    RawClient busy(port_);
    busy.send(get("/slow"));
    ASSERT_TRUE(eventually([&] { return handler_.entered.load(); }));
    // Of two that come while the only thread is busy one has to wait, the other is turned away.
    RawClient second(port_), third(port_);
    second.send(get("/waiting"));
    third.send(get("/waiting"));
    ASSERT_TRUE(eventually([&] { return handler_.turned_away == 1; }));
    handler_.released = true;
    server_->cancel();
    EXPECT_EQ(busy.receive().status, 200);
    const RawAnswer answers[] = {second.receive(), third.receive()};
    const bool second_waits = answers[0].status == 200;
    EXPECT_EQ(answers[second_waits ? 0 : 1].status, 200);
    const RawAnswer& refusal = answers[second_waits ? 1 : 0];
    EXPECT_EQ(refusal.status, 503);
    EXPECT_FALSE(refusal.header("Retry-After").empty());
    EXPECT_EQ(nlohmann::json::parse(refusal.body)["code"], "overloaded");
}

TEST_F(Http, AnswersUrgentRequestsWhileAllThreadsAreBusy) {
    HttpOptions options = quick();
    options.threads = 1;
    options.max_waiting = 0;
    restart(options);
    RawClient busy(port_);
    busy.send(get("/slow"));
    ASSERT_TRUE(eventually([&] { return handler_.entered.load(); }));
    EXPECT_EQ(ask(port_, get("/other")).status, 503);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(ask(port_, get("/urgent")).status, 200);
}

/// Connections that are opened and do no more than that.
std::vector<std::unique_ptr<RawClient>> clients(int port, std::size_t count,
                                                std::string_view bytes = {}) {
    std::vector<std::unique_ptr<RawClient>> opened;
    for (std::size_t i = 0; i < count; ++i) {
        opened.push_back(std::make_unique<RawClient>(port));
        opened.back()->send(bytes);
    }
    return opened;
}

TEST_F(Http, SilentConnectionsHoldNoThread) {
    restart({});  // the figures that the server has
    const HttpOptions usual;
    const auto silent =
        clients(port_, static_cast<std::size_t>(usual.threads) + usual.max_waiting + 8);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(alive());
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
    EXPECT_EQ(handler_.turned_away, 0);
    // None of them had to go.
    silent.front()->send(get("/first"));
    EXPECT_EQ(silent.front()->receive().status, 200);
}

TEST_F(Http, SilentConnectionsGiveWayTheOldestFirst) {
    HttpOptions options = quick();
    options.max_connections = 8;
    restart(options);
    const auto silent = clients(port_, 8);
    RawClient speaking(port_);
    speaking.send(get("/one"));
    EXPECT_EQ(speaking.receive().status, 200);
    EXPECT_TRUE(silent.front()->closed_within(5s));
    silent.back()->send(get("/last"));
    EXPECT_EQ(silent.back()->receive().status, 200);
    EXPECT_EQ(handler_.turned_away, 0);
}

TEST_F(Http, IdleConnectionsGiveWay) {
    HttpOptions options = quick();
    options.max_connections = 4;
    restart(options);
    RawClient idle(port_);
    idle.send(get("/"));
    EXPECT_EQ(idle.receive().header("Connection"), "");
    const auto busy = clients(port_, 3, get("/slow"));
    ASSERT_TRUE(eventually([&] { return handler_.handled == 4; }));
    const RawAnswer answer = ask(port_, get("/"));
    EXPECT_EQ(answer.status, 200);
    // Where places are scarce, a client is told that its connection ends.
    EXPECT_EQ(answer.header("Connection"), "close");
    EXPECT_TRUE(idle.closed_within(5s));
    EXPECT_EQ(handler_.turned_away, 0);
}

TEST_F(Http, SlowHeadersGiveWayAfterSilentConnections) {
    HttpOptions options = quick();
    options.max_connections = 4;
    restart(options);
    const auto slow = clients(port_, 2, "GET / HTT");
    const auto silent = clients(port_, 2);
    EXPECT_TRUE(alive());
    EXPECT_TRUE(silent.front()->closed_within(5s));
    const auto more = clients(port_, 3, "GET / HTT");
    EXPECT_EQ(slow.front()->receive().status, 503);
    EXPECT_TRUE(alive());
}

TEST_F(Http, BodiesThatHardlyMoveGiveWay) {
    HttpOptions options = quick();
    options.max_connections = 4;
    options.slow_after = 100ms;
    restart(options);
    const auto slow =
        clients(port_, 4, test::request("POST", "/", "Content-Length: 1000\r\n") + "a");
    EXPECT_TRUE(eventually([&] { return alive(); }));
    EXPECT_EQ(slow.front()->receive().status, 503);
}

TEST_F(Http, AnswersThatNobodyTakesGiveWayAndHoldNoThread) {
    HttpOptions options = quick();
    options.threads = 2;
    options.max_connections = 4;
    options.slow_after = 100ms;
    restart(options);
    std::string requests;
    for (int i = 0; i < 200; ++i) requests += get("/large");  // 20 MB of answers
    const auto deaf = clients(port_, 4, requests);
    EXPECT_TRUE(eventually([&] { return alive(); }));
}

TEST_F(Http, TurnsAwayWhenNobodyHasLessClaim) {
    HttpOptions options = quick();
    options.max_connections = 2;
    restart(options);
    const auto busy = clients(port_, 2, get("/slow"));
    ASSERT_TRUE(eventually([&] { return handler_.handled == 2; }));
    const RawAnswer refusal = ask(port_, get("/other"));
    EXPECT_EQ(refusal.status, 503);
    EXPECT_EQ(refusal.header("Connection"), "close");
    handler_.released = true;
    server_->cancel();
    for (const auto& client : busy) EXPECT_EQ(client->receive().status, 200);
}

TEST_F(Http, SaysCloseInTheLastAnswerOfAConnection) {
    HttpOptions options = quick();
    options.max_requests = 3;
    restart(options);
    RawClient client(port_);
    for (int i = 1; i <= 3; ++i) {
        client.send(get("/"));
        const RawAnswer answer = client.receive();
        ASSERT_EQ(answer.status, 200);
        EXPECT_EQ(answer.header("Connection"), i == 3 ? "close" : "") << i;
    }
    EXPECT_TRUE(client.closed_within(5s));
}

TEST_F(Http, AnswersEveryRequestOfMoreClientsThanThreads) {
    HttpOptions options = quick();
    options.threads = 2;
    options.max_connections = 48;
    restart(options);
    std::atomic<int> sent = 0, answered = 0;
    {
        std::vector<std::jthread> threads;
        for (int c = 0; c < 40; ++c) {
            threads.emplace_back([&] {
                auto client = std::make_unique<RawClient>(port_);
                for (int i = 0; i < 50; ++i) {
                    client->send(get("/"));
                    ++sent;
                    const RawAnswer answer = client->receive();
                    if (answer.status == 200) ++answered;
                    // Who is told that the connection ends opens another; nobody else has to.
                    if (answer.header("Connection") == "close") {
                        client.reset();
                        client = std::make_unique<RawClient>(port_);
                    }
                }
            });
        }
    }
    EXPECT_EQ(sent, 40 * 50);
    EXPECT_EQ(answered, sent);
}

TEST_F(Http, HoldsOnlySoManyBodiesAtOnce) {
    RawClient first(port_);
    first.send(test::request("POST", "/", "Content-Length: 100000\r\n") + "a");
    RawClient second(port_);
    second.send(test::request("POST", "/", "Content-Length: 100000\r\n") + "a");
    EXPECT_TRUE(eventually([&] { return ask(port_, post("/", "x")).status == 503; }));
    EXPECT_EQ(code_for(post("/", std::string(1000, 'x')), 503), "overloaded");
    first.send(std::string(99'999, 'a'));
    EXPECT_EQ(first.receive().status, 200);
    EXPECT_EQ(ask(port_, post("/", std::string(1000, 'x'))).status, 200);
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

TEST_F(Http, ServesManyClientsAtOnce) {
    std::atomic<int> right = 0;
    {
        std::vector<std::jthread> clients;
        for (int c = 0; c < 12; ++c) {
            clients.emplace_back([&, c] {
                for (int i = 0; i < 20; ++i) {
                    const std::string body = std::to_string(c) + "." + std::to_string(i);
                    const RawAnswer answer = ask(port_, post("/", body));
                    const auto json = nlohmann::json::parse(answer.body, nullptr, false);
                    if (!json.is_discarded() && json["body"] == body) ++right;
                }
            });
        }
    }
    EXPECT_EQ(right, 12 * 20);
}

}  // namespace
}  // namespace ossuary::server
