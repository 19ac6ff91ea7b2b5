#pragma once

#include <cassert>
#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "engine/core/error_code.h"

namespace ossuary {

/// What went wrong with data or environment. `message` names the file or field, what was found and
/// what was expected; `code` is stable across releases.
struct Error {
    ErrorCode code = ErrorCode::kInternal;
    std::string message;
};

/// A value or an Error. Bugs are asserts, never Errors.
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : storage_(std::move(value)) {}
    Result(Error error) : storage_(tl::unexpect, std::move(error)) {}
    Result(ErrorCode code, std::string message)
        : storage_(tl::unexpect, Error{code, std::move(message)}) {}

    [[nodiscard]] bool ok() const { return storage_.has_value(); }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] T& value() & {
        assert(ok());
        return *storage_;
    }
    [[nodiscard]] const T& value() const& {
        assert(ok());
        return *storage_;
    }
    [[nodiscard]] T&& value() && {
        assert(ok());
        return *std::move(storage_);
    }
    [[nodiscard]] const Error& error() const {
        assert(!ok());
        return storage_.error();
    }

    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    tl::expected<T, Error> storage_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : storage_(tl::unexpect, std::move(error)) {}
    Result(ErrorCode code, std::string message)
        : storage_(tl::unexpect, Error{code, std::move(message)}) {}

    [[nodiscard]] bool ok() const { return storage_.has_value(); }
    explicit operator bool() const { return ok(); }
    [[nodiscard]] const Error& error() const {
        assert(!ok());
        return storage_.error();
    }

private:
    tl::expected<void, Error> storage_;
};

}  // namespace ossuary
