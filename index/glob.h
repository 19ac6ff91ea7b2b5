#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace ossuary::index {

/// A pattern of file names as shells and .gitignore write them: `*` stands for any characters but
/// `/`, `?` for one, `[a-z]` and `[!a-z]` for one of a set, `**` for any number of folders, `\` for
/// the character after it as it is. Upper and lower case differ.
///
/// A pattern without `/` means names at any depth. One with a `/` means paths below the folder that
/// is walked, from their beginning (a leading `/` says just that). One that ends in `/` means
/// folders only; `x/**` means everything in x.
class Glob {
public:
    /// Errors: invalid_argument for an empty pattern, an unclosed `[` or a `\` at the end.
    static Result<Glob> parse(std::string_view pattern);

    /// @param path  below the folder that is walked, parts separated by `/`, no `/` at the ends
    [[nodiscard]] bool matches(std::string_view path, bool is_folder) const;

private:
    Glob() = default;

    std::string pattern_;      ///< without `/` at the ends
    bool names_only_ = false;  ///< to be held against the last part of a path
    bool folders_only_ = false;
};

}  // namespace ossuary::index
