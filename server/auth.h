#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "server/message.h"
#include "server/problem.h"

namespace ossuary::server {

/// Whether two texts are equal, in a time that depends on their lengths only.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b);

/// The administrator's key from the file (its first line), else from OSSUARY_ADMIN_KEY, else none.
/// Errors: file_unreadable; invalid_argument for a key of fewer than 16 characters.
Result<std::string> read_admin_key(const std::filesystem::path& file);

/// None when the request may administer, else why not.
/// @param key  empty where administration is off
std::optional<Problem> judge_admin(const RequestHead& head, std::string_view key);

}  // namespace ossuary::server
