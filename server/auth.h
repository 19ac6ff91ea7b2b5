#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "server/message.h"
#include "server/problem.h"

namespace ossuary::server {

/// Whether two texts are equal, in a time that depends on their lengths only.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b);

/// A key that requests show. That of a file (its first line) is followed: once another is there it
/// holds, and the one before opens nothing more. Safe to use from several threads.
class Key {
public:
    /// Of nothing: there is no key.
    Key();
    Key(Key&&) noexcept;
    Key& operator=(Key&&) noexcept;
    ~Key();

    /// @param file      empty: the key of the environment, else none
    /// @param variable  of the environment
    /// @param name      what messages call it, "administrator's key"
    /// Errors: file_unreadable; invalid_argument for a key of fewer than 16 characters.
    static Result<Key> load(const std::filesystem::path& file, const char* variable,
                            std::string name);

    /// Whether there is one; does not change.
    [[nodiscard]] bool exists() const;
    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] bool opens(std::string_view given) const;
    /// Reads the file again where it has changed; whether another key is there. What cannot be one
    /// changes nothing, and is told once. Errors: those of load.
    Result<bool> follow();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// None when the request may administer, else why not. The key comes as a bearer's.
std::optional<Problem> judge_admin(const RequestHead& head, const Key& admin);

/// None when the request may read, else why not: with the reader's key or the administrator's, as a
/// bearer's or as the password of HTTP's basic scheme (RFC 7617), which browsers ask people for.
std::optional<Problem> judge_reader(const RequestHead& head, const Key& reader, const Key& admin);

}  // namespace ossuary::server
