#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "server/http.h"
#include "tests/server/raw_client.h"

namespace ossuary::server {

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
    void complete(Response& response, const RequestHead&, const std::string& id) override {
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

/// A server of its own for each test, which answers with what it was asked.
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

}  // namespace ossuary::server
