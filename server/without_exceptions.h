#pragma once

#include <exception>
#include <new>

#include "engine/core/result.h"

namespace ossuary::server {

/// The edge of a thread, which no exception may leave: what `work`, a function that returns a
/// Result, throws becomes `out_of_memory` or `internal`.
template <typename Work>
auto without_exceptions(const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::kOutOfMemory, "not enough memory"};
    } catch (const std::exception& exception) {
        return Error{ErrorCode::kInternal, exception.what()};
    } catch (...) {
        return Error{ErrorCode::kInternal, "an exception without a text"};
    }
}

}  // namespace ossuary::server
