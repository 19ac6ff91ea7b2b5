#include "server/auth.h"

#include <cstdlib>
#include <fstream>
#include <utility>

#include "engine/core/mutex.h"
#include "index/file_stamp.h"

namespace ossuary::server {

namespace {

constexpr std::size_t kShortestKey = 16;

/// The credentials of a scheme; none where the request is of another.
std::optional<std::string> credentials(const std::string& authorization, std::string_view scheme) {
    const std::string_view text = authorization;
    if (text.size() <= scheme.size() || text[scheme.size()] != ' ' ||
        !same_name(text.substr(0, scheme.size()), scheme)) {
        return {};
    }
    return std::string(text.substr(scheme.size() + 1));
}

/// None where the text is not base64 (RFC 4648, section 4).
std::optional<std::string> from_base64(std::string_view text) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = kDigits.find(c);
        if (digit == std::string_view::npos) return {};
        bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xFFFFU;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
    }
    return bytes;
}

/// What a reader shows: a bearer's key, or a password whatever the name before it.
std::optional<std::string> shown_by_reader(const RequestHead& head) {
    const std::string authorization = head.header("Authorization");
    if (auto key = credentials(authorization, "Bearer")) return key;
    const auto basic = credentials(authorization, "Basic");
    const auto pair = basic ? from_base64(*basic) : std::nullopt;
    const std::size_t colon = pair ? pair->find(':') : std::string::npos;
    if (colon == std::string::npos) return {};
    return pair->substr(colon + 1);
}

Result<std::string> read_key(const std::filesystem::path& file, const char* variable,
                             const std::string& name) {
    std::string key;
    if (!file.empty()) {
        std::ifstream in(file);
        if (!std::getline(in, key)) {
            return {ErrorCode::kFileUnreadable, file.string() + ": no key can be read"};
        }
        while (!key.empty() && (key.back() == '\r' || key.back() == ' ')) key.pop_back();
    } else if (const char* value = std::getenv(variable)) {
        key = value;
        if (key.empty()) return key;
    } else {
        return key;
    }
    if (key.size() < kShortestKey) {
        return {ErrorCode::kInvalidArgument, "the " + name + " has " + std::to_string(key.size()) +
                                                 " characters; at least 16 are needed"};
    }
    return key;
}

}  // namespace

bool equal_in_constant_time(std::string_view a, std::string_view b) {
    // Always walks all of `a`, whatever `b` is, and never leaves early.
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const char other = b.empty() ? '\0' : b[i % b.size()];
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(other);
    }
    return difference == 0;
}

struct Key::State {
    std::filesystem::path file;
    std::string name;
    Mutex mutex;
    std::string key OSSUARY_GUARDED_BY(mutex);
    std::optional<index::FileStamp> stamp
        OSSUARY_GUARDED_BY(mutex);  ///< of the file as it was read
};

Key::Key() : state_(std::make_unique<State>()) {}
Key::Key(Key&&) noexcept = default;
Key& Key::operator=(Key&&) noexcept = default;
Key::~Key() = default;

Result<Key> Key::load(const std::filesystem::path& file, const char* variable, std::string name) {
    Key loaded;
    State& state = *loaded.state_;
    // Before it is read: what is written meanwhile is seen as a change.
    const auto stamp = file.empty() ? std::nullopt : index::stamp_of(file);
    auto key = read_key(file, variable, name);
    if (!key) return key.error();
    state.file = file;
    state.name = std::move(name);
    const Lock lock(state.mutex);
    state.key = *std::move(key);
    state.stamp = stamp;
    return loaded;
}

bool Key::exists() const {
    const Lock lock(state_->mutex);
    return !state_->key.empty();
}

const std::string& Key::name() const { return state_->name; }

bool Key::opens(std::string_view given) const {
    const Lock lock(state_->mutex);
    return !state_->key.empty() && equal_in_constant_time(given, state_->key);
}

Result<bool> Key::follow() {
    if (state_->file.empty()) return false;
    const auto stamp = index::stamp_of(state_->file);
    const Lock lock(state_->mutex);
    if (stamp == state_->stamp) return false;
    state_->stamp = stamp;
    auto key = read_key(state_->file, nullptr, state_->name);
    if (!key) return key.error();
    if (*key == state_->key) return false;
    state_->key = *std::move(key);
    return true;
}

std::optional<Problem> judge_admin(const RequestHead& head, const Key& admin) {
    if (!admin.exists()) {
        return problem(RequestFault::kAdminDisabled,
                       "This server was started without an administrator's key.");
    }
    const auto given = credentials(head.header("Authorization"), "Bearer");
    if (given && admin.opens(*given)) return std::nullopt;
    Problem refusal = given ? problem(RequestFault::kAdminKeyWrong, "That is not the key.")
                            : problem(RequestFault::kAdminKeyMissing,
                                      "Send the key as: Authorization: Bearer KEY.");
    refusal.headers.push_back({"WWW-Authenticate", "Bearer realm=\"ossuary\""});
    return refusal;
}

std::optional<Problem> judge_reader(const RequestHead& head, const Key& reader, const Key& admin) {
    if (!reader.exists()) return std::nullopt;
    const auto given = shown_by_reader(head);
    if (given && (reader.opens(*given) || admin.opens(*given))) return std::nullopt;
    Problem refusal = given ? problem(RequestFault::kReadKeyWrong, "That is not the key.")
                            : problem(RequestFault::kReadKeyMissing,
                                      "This server is read with a key: send it as Authorization: "
                                      "Bearer KEY, or as the password of the basic scheme.");
    // Browsers then ask for it and send it with everything that the gallery fetches.
    refusal.headers.push_back({"WWW-Authenticate", "Basic realm=\"ossuary\", charset=\"UTF-8\""});
    return refusal;
}

}  // namespace ossuary::server
