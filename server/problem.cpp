#include "server/problem.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "index/json_text.h"

namespace ossuary::server {
namespace {

struct FaultRow {
    RequestFault fault;
    ProblemRow row;
};

const std::vector<FaultRow>& fault_rows() {
    using enum RequestFault;
    static const std::vector<FaultRow> rows = {
        {kMalformedRequest, {"malformed_request", 400, "Malformed request"}},
        {kControlCharacters, {"control_characters", 400, "Control characters in the request"}},
        {kBadEscape, {"bad_escape", 400, "Malformed percent-encoding"}},
        {kAmbiguousLength, {"ambiguous_length", 400, "Ambiguous body length"}},
        {kBodyUnexpected, {"body_unexpected", 400, "Unexpected body"}},
        {kBodyIncomplete, {"body_incomplete", 400, "Incomplete body"}},
        {kBodyEmpty, {"body_empty", 400, "Empty body"}},
        {kMultipartInvalid, {"multipart_invalid", 400, "Malformed form"}},
        {kParameterUnknown, {"parameter_unknown", 400, "Unknown parameter"}},
        {kParameterRepeated, {"parameter_repeated", 400, "Repeated parameter"}},
        {kParameterMissing, {"parameter_missing", 400, "Missing parameter"}},
        {kParameterInvalid, {"parameter_invalid", 400, "Invalid parameter"}},
        {kAdminKeyMissing, {"admin_key_missing", 401, "Administrator's key needed"}},
        {kAdminKeyWrong, {"admin_key_wrong", 401, "Administrator's key not accepted"}},
        {kReadKeyMissing, {"read_key_missing", 401, "Key needed"}},
        {kReadKeyWrong, {"read_key_wrong", 401, "Key not accepted"}},
        {kAdminDisabled, {"admin_disabled", 403, "Administration is off"}},
        {kCrossSiteRequest, {"cross_site_request", 403, "Request from another site"}},
        {kRouteNotFound, {"route_not_found", 404, "No such resource"}},
        {kFileNotServed, {"file_not_served", 404, "No such file"}},
        {kJobNotFound, {"job_not_found", 404, "No such job"}},
        {kQueryNotFound, {"query_not_found", 404, "The query is gone"}},
        {kOriginalNotAvailable, {"original_not_available", 404, "No original file"}},
        {kSegmentsNotAvailable, {"segments_not_available", 404, "No decomposition"}},
        {kThumbnailNotAvailable, {"thumbnail_not_available", 404, "No thumbnail"}},
        {kMethodNotAllowed, {"method_not_allowed", 405, "Method not allowed"}},
        {kRequestTimeout, {"request_timeout", 408, "Request took too long to arrive"}},
        {kLengthRequired, {"length_required", 411, "Length required"}},
        {kPayloadTooLarge, {"payload_too_large", 413, "Body too large"}},
        {kUriTooLong, {"uri_too_long", 414, "Address too long"}},
        {kMediaTypeUnsupported, {"media_type_unsupported", 415, "Unsupported content type"}},
        {kContentEncodingUnsupported,
         {"content_encoding_unsupported", 415, "Unsupported content encoding"}},
        {kExpectationFailed, {"expectation_failed", 417, "Unsupported expectation"}},
        {kHostNotServed, {"host_not_served", 421, "Host not served here"}},
        {kTooManyFields, {"too_many_fields", 431, "Too many header fields"}},
        {kFieldsTooLarge, {"fields_too_large", 431, "Header too large"}},
        {kMethodUnknown, {"method_unknown", 501, "Unknown method"}},
        {kVersionUnsupported, {"version_unsupported", 505, "Unsupported version of HTTP"}},
        {kOverloaded, {"overloaded", 503, "Too much to do", 2}},
        {kSearchTimeout, {"search_timeout", 503, "Out of time", 5}},
        {kShuttingDown, {"shutting_down", 503, "Shutting down", 5}},
    };
    return rows;
}

struct ErrorRow {
    ErrorCode code;
    int status;
    std::string_view title;
    int retry_after_seconds = 0;
};

const std::vector<ErrorRow>& error_rows() {
    using enum ErrorCode;
    static const std::vector<ErrorRow> rows = {
        {kInvalidArgument, 400, "Invalid argument"},
        {kCancelled, 503, "Cancelled", 5},
        {kInternal, 500, "Internal error"},
        {kOutOfMemory, 503, "Out of memory", 10},
        {kFileNotFound, 500, "File not found"},
        {kFileUnreadable, 500, "File unreadable"},
        {kFileUnwritable, 500, "File unwritable"},
        {kFileTooLarge, 413, "Model too large"},
        {kFormatUnsupported, 415, "Unsupported model format"},
        {kFormatUnknown, 415, "Unknown model format"},
        {kOffHeader, 422, "Unusable OFF header"},
        {kOffBinary, 422, "Binary OFF"},
        {kOffDimension, 422, "OFF of another dimension"},
        {kOffCounts, 422, "Unusable OFF counts"},
        {kOffTooManyVertices, 413, "Too many vertices"},
        {kOffTooManyFaces, 413, "Too many faces"},
        {kOffTooManyCorners, 413, "Too many corners"},
        {kOffTruncated, 422, "Truncated model"},
        {kOffBadNumber, 422, "Malformed number"},
        {kOffNonFinite, 422, "Number not finite"},
        {kOffIndexOutOfRange, 422, "Vertex index out of range"},
        {kOffLineTooLong, 422, "Line too long"},
        {kStlSyntax, 422, "Unusable STL"},
        {kStlTooManyVertices, 413, "Too many vertices"},
        {kStlTooManyFaces, 413, "Too many faces"},
        {kStlTooManyCorners, 413, "Too many corners"},
        {kStlTruncated, 422, "Truncated model"},
        {kStlBadNumber, 422, "Malformed number"},
        {kStlNonFinite, 422, "Number not finite"},
        {kObjBinary, 422, "OBJ with binary data"},
        {kObjTooManyVertices, 413, "Too many vertices"},
        {kObjTooManyFaces, 413, "Too many faces"},
        {kObjTooManyCorners, 413, "Too many corners"},
        {kObjTruncated, 422, "Truncated model"},
        {kObjBadNumber, 422, "Malformed number"},
        {kObjNonFinite, 422, "Number not finite"},
        {kObjIndexOutOfRange, 422, "Vertex index out of range"},
        {kPlyHeader, 422, "Unusable PLY header"},
        {kPlyTooManyVertices, 413, "Too many vertices"},
        {kPlyTooManyFaces, 413, "Too many faces"},
        {kPlyTooManyCorners, 413, "Too many corners"},
        {kPlyTruncated, 422, "Truncated model"},
        {kPlyBadNumber, 422, "Malformed number"},
        {kPlyNonFinite, 422, "Number not finite"},
        {kPlyIndexOutOfRange, 422, "Vertex index out of range"},
        {kXyzTooManyPoints, 413, "Too many points"},
        {kXyzTruncated, 422, "Truncated model"},
        {kXyzBadNumber, 422, "Malformed number"},
        {kXyzNonFinite, 422, "Number not finite"},
        {kThreeMfInvalid, 422, "Unusable 3MF"},
        {kThreeMfExtension, 422, "Unknown 3MF extension"},
        {kGltfInvalid, 422, "Unusable glTF"},
        {kGltfExtension, 422, "Unknown glTF extension"},
        {kGltfBuffer, 422, "glTF without its buffer"},
        {kSceneInvalid, 422, "Unusable scene"},
        {kModelTooManyVertices, 413, "Too many vertices"},
        {kModelTooManyFaces, 413, "Too many faces"},
        {kModelTooManyCorners, 413, "Too many corners"},
        {kModelNonFinite, 422, "Number not finite"},
        {kReaderTime, 422, "Reading took too long"},
        {kReaderMemory, 422, "Reading took too much memory"},
        {kReaderCrashed, 422, "Reading ended the reader"},
        {kReaderUnavailable, 500, "No reader"},
        {kMeshEmpty, 422, "Model without triangles"},
        {kMeshNoExtent, 422, "Model without extent"},
        {kSolidEmpty, 422, "Model without a solid"},
        {kNpyInvalid, 422, "Unusable volume"},
        {kNrrdInvalid, 422, "Unusable NRRD file"},
        {kNiftiInvalid, 422, "Unusable NIfTI file"},
        {kBinvoxInvalid, 422, "Unusable binvox file"},
        {kVolumeDetached, 422, "Volume whose values lie in another file"},
        {kGzipInvalid, 422, "Unusable gzip file"},
        {kArchiveInvalid, 422, "Unusable ZIP archive"},
        {kArchiveMember, 422, "No such file in the archive"},
        {kArchiveSeveral, 422, "Archive of several models"},
        {kArchiveEmpty, 422, "Archive without models"},
        {kObjectMissing, 422, "No such object"},
        {kVolumeTooLarge, 413, "Volume too large"},
        {kMeshScale, 422, "Mesh of a scale that floats cannot hold"},
        {kPointsTooFew, 422, "Too few points"},
        {kClaInvalid, 422, "Unusable classification"},
        {kClaUnknownModel, 422, "Classification names an unknown model"},
        {kSegInvalid, 422, "Unusable segmentation"},
        {kIndexNotFound, 503, "Index not found", 10},
        {kIndexForeign, 500, "Not an index"},
        {kIndexNewer, 500, "Index of a newer version"},
        {kIndexCorrupt, 500, "Index damaged"},
        {kIndexBusy, 503, "Index busy", 2},
        {kIndexIo, 500, "Index unreadable"},
        {kIndexParameters, 500, "Index of other parameters"},
        {kModelNotFound, 404, "No such model"},
        {kEvaluationNotFound, 404, "No such evaluation"},
        {kIndexReplaced, 503, "Index replaced", 5},
        {kUploadAbandoned, 500, "Upload given up"},
        {kPruneRefused, 409, "Pruning refused"},
    };
    return rows;
}

constexpr ProblemRow kUnknownRow = {"internal", 500, "Internal error"};

}  // namespace

const std::vector<ProblemRow>& problem_table() {
    static const std::vector<ProblemRow> table = [] {
        std::vector<ProblemRow> rows;
        for (const ErrorRow& row : error_rows()) {
            rows.push_back({to_string(row.code), row.status, row.title, row.retry_after_seconds});
        }
        for (const FaultRow& row : fault_rows()) rows.push_back(row.row);
        return rows;
    }();
    return table;
}

const ProblemRow& problem_row(ErrorCode code) {
    const std::string_view name = to_string(code);
    const auto& table = problem_table();
    const auto row = std::find_if(table.begin(), table.end(),
                                  [&](const ProblemRow& each) { return each.code == name; });
    // A code without a row would be a bug (the tests look for one), but not one to end a server
    // over in the middle of a request.
    return row == table.end() ? kUnknownRow : *row;
}

const ProblemRow& problem_row(RequestFault fault) {
    const auto& rows = fault_rows();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const FaultRow& each) { return each.fault == fault; });
    return row == rows.end() ? kUnknownRow : row->row;
}

Problem problem(RequestFault fault, std::string detail, std::string parameter) {
    return {problem_row(fault), std::move(detail), std::move(parameter), {}, {}};
}

Problem problem(const Error& error) {
    const ProblemRow& row = problem_row(error.code);
    if (row.status < 500) return {row, error.message, {}, {}, {}};
    return {row,
            "The server could not do this; its log says why under the request id.",
            {},
            {},
            std::string(to_string(error.code)) + ": " + error.message};
}

Response to_response(const Problem& problem, std::string_view instance,
                     std::string_view request_id) {
    nlohmann::ordered_json document = {
        {"type", "about:blank"},    {"title", problem.row.title}, {"status", problem.row.status},
        {"detail", problem.detail}, {"code", problem.row.code},   {"instance", instance},
        {"request_id", request_id},
    };
    if (!problem.parameter.empty()) document["parameter"] = problem.parameter;

    Response response;
    response.status = problem.row.status;
    response.content_type = "application/problem+json";
    // Bytes of the request that are not UTF-8 are shown as U+FFFD rather than refused again.
    response.body = index::json_text(document);
    response.code = problem.row.code;
    response.cause = problem.cause;
    response.headers = problem.headers;
    response.set_header("Cache-Control", "no-store");
    if (problem.row.retry_after_seconds > 0) {
        response.set_header("Retry-After", std::to_string(problem.row.retry_after_seconds));
    }
    return response;
}

}  // namespace ossuary::server
