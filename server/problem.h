#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "server/message.h"

namespace ossuary::server {

/// What can be wrong with a request itself; the engine's own vocabulary is `ErrorCode`. The names
/// (`to_string`) are part of the interface, like those of `ErrorCode`.
enum class RequestFault {
    kMalformedRequest,
    kControlCharacters,
    kBadEscape,
    kAmbiguousLength,
    kBodyUnexpected,
    kBodyIncomplete,
    kBodyEmpty,
    kMultipartInvalid,
    kParameterUnknown,
    kParameterRepeated,
    kParameterMissing,
    kParameterInvalid,
    kAdminKeyMissing,
    kAdminKeyWrong,
    kReadKeyMissing,
    kReadKeyWrong,
    kAdminDisabled,
    kCrossSiteRequest,
    kRouteNotFound,
    kFileNotServed,
    kJobNotFound,
    kQueryNotFound,
    kOriginalNotAvailable,
    kSegmentsNotAvailable,
    kThumbnailNotAvailable,
    kMethodNotAllowed,
    kRequestTimeout,
    kLengthRequired,
    kPayloadTooLarge,
    kUriTooLong,
    kMediaTypeUnsupported,
    kContentEncodingUnsupported,
    kExpectationFailed,
    kHostNotServed,
    kTooManyFields,
    kFieldsTooLarge,
    kMethodUnknown,
    kVersionUnsupported,
    kOverloaded,
    kSearchTimeout,
    kShuttingDown,
};

/// One row of the table from what went wrong to what HTTP calls it.
struct ProblemRow {
    std::string_view code;
    int status = 500;
    std::string_view title;
    int retry_after_seconds = 0;  ///< 0: no Retry-After
};

/// The table. Every `ErrorCode` and every `RequestFault` has one row.
[[nodiscard]] const std::vector<ProblemRow>& problem_table();

[[nodiscard]] const ProblemRow& problem_row(ErrorCode code);
[[nodiscard]] const ProblemRow& problem_row(RequestFault fault);

/// A problem on its way to becoming an answer: `detail` is for people, `parameter` names the
/// request's parameter at fault, if one is.
struct Problem {
    ProblemRow row;
    std::string detail;
    std::string parameter;
    Fields headers;
    std::string cause;  ///< for the log only
};

[[nodiscard]] Problem problem(RequestFault fault, std::string detail, std::string parameter = {});

/// The details of faults on the server's side (5xx) may name files of this machine: they are
/// replaced by a plain sentence, and the error's own message becomes the `cause`.
[[nodiscard]] Problem problem(const Error& error);

/// The RFC 9457 document.
/// @param instance    the path that was asked for
/// @param request_id  as in the answer's X-Request-Id
[[nodiscard]] Response to_response(const Problem& problem, std::string_view instance,
                                   std::string_view request_id);

}  // namespace ossuary::server
