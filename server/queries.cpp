#include "server/queries.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

namespace ossuary::server {
namespace {

/// 128 bits of the system's own randomness: a token is all that protects an upload.
std::string new_token() {
    std::random_device random;
    std::string token;
    for (int word = 0; word < 4; ++word) {
        std::array<char, 9> digits{};
        std::snprintf(digits.data(), digits.size(), "%08x", random());
        token += digits.data();
    }
    return token;
}

}  // namespace

Queries::Queries(Limits limits, std::function<Clock::time_point()> now)
    : limits_(limits),
      now_(std::move(now)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

std::string Queries::keep(std::shared_ptr<index::QueryModel> model) {
    const std::size_t bytes = model->bytes();
    if (bytes > limits_.bytes || limits_.count == 0) return {};
    const Lock lock(mutex_);
    drop_idle();
    make_room(bytes);
    std::string token = new_token();
    kept_[token] = {std::move(model), bytes, now_()};
    bytes_ += bytes;
    return token;
}

std::shared_ptr<index::QueryModel> Queries::find(const std::string& token) {
    const Lock lock(mutex_);
    drop_idle();
    const auto found = kept_.find(token);
    if (found == kept_.end()) return nullptr;
    found->second.used = now_();
    return found->second.model;
}

/// Memory is given back also while nobody asks for anything.
void Queries::work(const std::stop_token& stop) {
    constexpr std::chrono::seconds kBetween{30};
    Lock lock(mutex_);
    while (!wake_.wait_for(lock, stop, kBetween, [] { return false; }) && !stop.stop_requested()) {
        drop_idle();
    }
}

void Queries::drop_idle() {
    const auto now = now_();
    for (auto each = kept_.begin(); each != kept_.end();) {
        const auto next = std::next(each);
        if (now - each->second.used > limits_.idle) drop(each);
        each = next;
    }
}

void Queries::drop(Map::iterator kept) {
    bytes_ -= kept->second.bytes;
    kept_.erase(kept);
}

void Queries::make_room(std::size_t bytes) {
    while (!kept_.empty() && (bytes_ + bytes > limits_.bytes || kept_.size() >= limits_.count)) {
        drop(std::min_element(kept_.begin(), kept_.end(), [](const auto& a, const auto& b) {
            return a.second.used < b.second.used;
        }));
    }
}

}  // namespace ossuary::server
