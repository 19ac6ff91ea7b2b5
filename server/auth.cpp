#include "server/auth.h"

#include <cstdlib>
#include <fstream>

namespace ossuary::server {

bool equal_in_constant_time(std::string_view a, std::string_view b) {
    // Always walks all of `a`, whatever `b` is, and never leaves early.
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const char other = b.empty() ? '\0' : b[i % b.size()];
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(other);
    }
    return difference == 0;
}

Result<std::string> read_admin_key(const std::filesystem::path& file) {
    constexpr std::size_t kShortest = 16;
    std::string key;
    if (!file.empty()) {
        std::ifstream in(file);
        if (!std::getline(in, key)) {
            return {ErrorCode::kFileUnreadable, file.string() + ": no key can be read"};
        }
        while (!key.empty() && (key.back() == '\r' || key.back() == ' ')) key.pop_back();
    } else if (const char* value = std::getenv("OSSUARY_ADMIN_KEY")) {
        key = value;
        if (key.empty()) return key;
    } else {
        return key;
    }
    if (key.size() < kShortest) {
        return {ErrorCode::kInvalidArgument, "the administrator's key has " +
                                                 std::to_string(key.size()) +
                                                 " characters; at least 16 are needed"};
    }
    return key;
}

std::optional<Problem> judge_admin(const RequestHead& head, std::string_view key) {
    if (key.empty()) {
        return problem(RequestFault::kAdminDisabled,
                       "This server was started without an administrator's key.");
    }
    constexpr std::string_view kScheme = "Bearer ";
    const std::string given = head.header("Authorization");
    const bool bearer = same_name(std::string_view(given).substr(0, kScheme.size()), kScheme);
    if (bearer && equal_in_constant_time(std::string_view(given).substr(kScheme.size()), key)) {
        return std::nullopt;
    }
    Problem refusal = bearer ? problem(RequestFault::kAdminKeyWrong, "That is not the key.")
                             : problem(RequestFault::kAdminKeyMissing,
                                       "Send the key as: Authorization: Bearer KEY.");
    refusal.headers.push_back({"WWW-Authenticate", "Bearer realm=\"ossuary\""});
    return refusal;
}

}  // namespace ossuary::server
