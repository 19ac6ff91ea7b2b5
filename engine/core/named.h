#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace ossuary {

/// What the reader of a file came to; its error's message, where it has one, begins with the file's
/// `name` and a comma.
template <typename T>
Result<T> named(std::string_view name, Result<T> result) {
    if (result.ok()) return result;
    return {result.error().code, std::string(name) + ", " + result.error().message};
}

}  // namespace ossuary
