#include "server/progress.h"

namespace ossuary::server {

Progress::Report::Report(Progress& owner, std::string token)
    : owner_(owner), token_([&] {
          const Lock lock(owner.mutex_);
          const bool asked = !token.empty();
          return asked && owner.stages_.try_emplace(token, "wait").second ? std::move(token)
                                                                          : std::string();
      }()) {}

Progress::Report::~Report() {
    if (token_.empty()) return;
    const Lock lock(owner_.mutex_);
    owner_.stages_.erase(token_);
}

void Progress::Report::stage(std::string_view name) {
    if (token_.empty()) return;
    const Lock lock(owner_.mutex_);
    owner_.stages_[token_] = name;
}

std::optional<std::string> Progress::find(const std::string& token) const {
    const Lock lock(mutex_);
    const auto found = stages_.find(token);
    if (found == stages_.end()) return std::nullopt;
    return found->second;
}

bool is_token(std::string_view text) {
    constexpr std::size_t kSize = 32;
    return text.size() == kSize &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace ossuary::server
