// Who may hold a thread, a connection or memory, and who has to give way.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "tests/server/http_fixture.h"

namespace ossuary::server {
namespace {

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
    // Whichever the server saw first.
    const auto gone = [](const auto& client) { return client->has_arrived(); };
    ASSERT_TRUE(eventually([&] { return std::any_of(slow.begin(), slow.end(), gone); }));
    EXPECT_EQ((*std::find_if(slow.begin(), slow.end(), gone))->receive().status, 503);
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
    // Each client has one, and one more that the server has not seen the end of.
    options.max_connections = 2 * 40;
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
