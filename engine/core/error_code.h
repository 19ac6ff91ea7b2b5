#pragma once

#include <array>
#include <string_view>

namespace ossuary {

/// The stable vocabulary of everything that can go wrong with data or environment. The names
/// returned by `to_string` are part of the interface: they are stored in the index, printed by the
/// command line and sent in problem documents, so they are never renamed or reused.
enum class ErrorCode {
    // any stage
    kInvalidArgument,
    kCancelled,
    kInternal,
    kOutOfMemory,
    // files
    kFileNotFound,
    kFileUnreadable,
    kFileUnwritable,
    kFileTooLarge,
    kFormatUnsupported,
    kFormatUnknown,
    // OFF
    kOffHeader,
    kOffBinary,
    kOffDimension,
    kOffCounts,
    kOffTooManyVertices,
    kOffTooManyFaces,
    kOffTooManyCorners,
    kOffTruncated,
    kOffBadNumber,
    kOffNonFinite,
    kOffIndexOutOfRange,
    kOffLineTooLong,
    // STL
    kStlSyntax,
    kStlTooManyVertices,
    kStlTooManyFaces,
    kStlTooManyCorners,
    kStlTruncated,
    kStlBadNumber,
    kStlNonFinite,
    // OBJ
    kObjBinary,
    kObjTooManyVertices,
    kObjTooManyFaces,
    kObjTooManyCorners,
    kObjTruncated,
    kObjBadNumber,
    kObjNonFinite,
    kObjIndexOutOfRange,
    // PLY
    kPlyHeader,
    kPlyTooManyVertices,
    kPlyTooManyFaces,
    kPlyTooManyCorners,
    kPlyTruncated,
    kPlyBadNumber,
    kPlyNonFinite,
    kPlyIndexOutOfRange,
    // points as text
    kXyzTooManyPoints,
    kXyzTruncated,
    kXyzBadNumber,
    kXyzNonFinite,
    // 3MF
    kThreeMfInvalid,
    kThreeMfExtension,
    // glTF
    kGltfInvalid,
    kGltfExtension,
    kGltfBuffer,
    // COLLADA, X3D, AMF, FBX
    kSceneInvalid,
    // whatever the reader process reads
    kModelTooManyVertices,
    kModelTooManyFaces,
    kModelTooManyCorners,
    kModelNonFinite,
    // the reader process itself
    kReaderTime,
    kReaderMemory,
    kReaderCrashed,
    kReaderUnavailable,
    // meshes and volumes
    kMeshEmpty,
    kMeshNoExtent,
    kSolidEmpty,
    kNpyInvalid,
    kNrrdInvalid,
    kNiftiInvalid,
    kBinvoxInvalid,
    kVolumeDetached,
    kGzipInvalid,
    kArchiveInvalid,
    kArchiveMember,
    kArchiveSeveral,
    kArchiveEmpty,
    kObjectMissing,
    kVolumeTooLarge,
    kMeshScale,
    kPointsTooFew,
    // classification files, labels
    kClaInvalid,
    kClaUnknownModel,
    kSegInvalid,
    // the index
    kIndexNotFound,
    kIndexForeign,
    kIndexNewer,
    kIndexCorrupt,
    kIndexBusy,
    kIndexIo,
    kIndexParameters,
    kModelNotFound,
    kEvaluationNotFound,
    kIndexReplaced,
    kUploadAbandoned,
    kPruneRefused,
};

struct ErrorCodeName {
    ErrorCode code;
    std::string_view name;
};

/// Every code with its stable name, in the order of the enumeration.
inline constexpr std::array kErrorCodeNames = {
    ErrorCodeName{ErrorCode::kInvalidArgument, "invalid_argument"},
    ErrorCodeName{ErrorCode::kCancelled, "cancelled"},
    ErrorCodeName{ErrorCode::kInternal, "internal"},
    ErrorCodeName{ErrorCode::kOutOfMemory, "out_of_memory"},
    ErrorCodeName{ErrorCode::kFileNotFound, "file_not_found"},
    ErrorCodeName{ErrorCode::kFileUnreadable, "file_unreadable"},
    ErrorCodeName{ErrorCode::kFileUnwritable, "file_unwritable"},
    ErrorCodeName{ErrorCode::kFileTooLarge, "file_too_large"},
    ErrorCodeName{ErrorCode::kFormatUnsupported, "format_unsupported"},
    ErrorCodeName{ErrorCode::kFormatUnknown, "format_unknown"},
    ErrorCodeName{ErrorCode::kOffHeader, "off_header"},
    ErrorCodeName{ErrorCode::kOffBinary, "off_binary"},
    ErrorCodeName{ErrorCode::kOffDimension, "off_dimension"},
    ErrorCodeName{ErrorCode::kOffCounts, "off_counts"},
    ErrorCodeName{ErrorCode::kOffTooManyVertices, "off_too_many_vertices"},
    ErrorCodeName{ErrorCode::kOffTooManyFaces, "off_too_many_faces"},
    ErrorCodeName{ErrorCode::kOffTooManyCorners, "off_too_many_corners"},
    ErrorCodeName{ErrorCode::kOffTruncated, "off_truncated"},
    ErrorCodeName{ErrorCode::kOffBadNumber, "off_bad_number"},
    ErrorCodeName{ErrorCode::kOffNonFinite, "off_non_finite"},
    ErrorCodeName{ErrorCode::kOffIndexOutOfRange, "off_index_out_of_range"},
    ErrorCodeName{ErrorCode::kOffLineTooLong, "off_line_too_long"},
    ErrorCodeName{ErrorCode::kStlSyntax, "stl_syntax"},
    ErrorCodeName{ErrorCode::kStlTooManyVertices, "stl_too_many_vertices"},
    ErrorCodeName{ErrorCode::kStlTooManyFaces, "stl_too_many_faces"},
    ErrorCodeName{ErrorCode::kStlTooManyCorners, "stl_too_many_corners"},
    ErrorCodeName{ErrorCode::kStlTruncated, "stl_truncated"},
    ErrorCodeName{ErrorCode::kStlBadNumber, "stl_bad_number"},
    ErrorCodeName{ErrorCode::kStlNonFinite, "stl_non_finite"},
    ErrorCodeName{ErrorCode::kObjBinary, "obj_binary"},
    ErrorCodeName{ErrorCode::kObjTooManyVertices, "obj_too_many_vertices"},
    ErrorCodeName{ErrorCode::kObjTooManyFaces, "obj_too_many_faces"},
    ErrorCodeName{ErrorCode::kObjTooManyCorners, "obj_too_many_corners"},
    ErrorCodeName{ErrorCode::kObjTruncated, "obj_truncated"},
    ErrorCodeName{ErrorCode::kObjBadNumber, "obj_bad_number"},
    ErrorCodeName{ErrorCode::kObjNonFinite, "obj_non_finite"},
    ErrorCodeName{ErrorCode::kObjIndexOutOfRange, "obj_index_out_of_range"},
    ErrorCodeName{ErrorCode::kPlyHeader, "ply_header"},
    ErrorCodeName{ErrorCode::kPlyTooManyVertices, "ply_too_many_vertices"},
    ErrorCodeName{ErrorCode::kPlyTooManyFaces, "ply_too_many_faces"},
    ErrorCodeName{ErrorCode::kPlyTooManyCorners, "ply_too_many_corners"},
    ErrorCodeName{ErrorCode::kPlyTruncated, "ply_truncated"},
    ErrorCodeName{ErrorCode::kPlyBadNumber, "ply_bad_number"},
    ErrorCodeName{ErrorCode::kPlyNonFinite, "ply_non_finite"},
    ErrorCodeName{ErrorCode::kPlyIndexOutOfRange, "ply_index_out_of_range"},
    ErrorCodeName{ErrorCode::kXyzTooManyPoints, "xyz_too_many_points"},
    ErrorCodeName{ErrorCode::kXyzTruncated, "xyz_truncated"},
    ErrorCodeName{ErrorCode::kXyzBadNumber, "xyz_bad_number"},
    ErrorCodeName{ErrorCode::kXyzNonFinite, "xyz_non_finite"},
    ErrorCodeName{ErrorCode::kThreeMfInvalid, "three_mf_invalid"},
    ErrorCodeName{ErrorCode::kThreeMfExtension, "three_mf_extension"},
    ErrorCodeName{ErrorCode::kGltfInvalid, "gltf_invalid"},
    ErrorCodeName{ErrorCode::kGltfExtension, "gltf_extension"},
    ErrorCodeName{ErrorCode::kGltfBuffer, "gltf_buffer"},
    ErrorCodeName{ErrorCode::kSceneInvalid, "scene_invalid"},
    ErrorCodeName{ErrorCode::kModelTooManyVertices, "model_too_many_vertices"},
    ErrorCodeName{ErrorCode::kModelTooManyFaces, "model_too_many_faces"},
    ErrorCodeName{ErrorCode::kModelTooManyCorners, "model_too_many_corners"},
    ErrorCodeName{ErrorCode::kModelNonFinite, "model_non_finite"},
    ErrorCodeName{ErrorCode::kReaderTime, "reader_time"},
    ErrorCodeName{ErrorCode::kReaderMemory, "reader_memory"},
    ErrorCodeName{ErrorCode::kReaderCrashed, "reader_crashed"},
    ErrorCodeName{ErrorCode::kReaderUnavailable, "reader_unavailable"},
    ErrorCodeName{ErrorCode::kMeshEmpty, "mesh_empty"},
    ErrorCodeName{ErrorCode::kMeshNoExtent, "mesh_no_extent"},
    ErrorCodeName{ErrorCode::kSolidEmpty, "solid_empty"},
    ErrorCodeName{ErrorCode::kNpyInvalid, "npy_invalid"},
    ErrorCodeName{ErrorCode::kNrrdInvalid, "nrrd_invalid"},
    ErrorCodeName{ErrorCode::kNiftiInvalid, "nifti_invalid"},
    ErrorCodeName{ErrorCode::kBinvoxInvalid, "binvox_invalid"},
    ErrorCodeName{ErrorCode::kVolumeDetached, "volume_detached"},
    ErrorCodeName{ErrorCode::kGzipInvalid, "gzip_invalid"},
    ErrorCodeName{ErrorCode::kArchiveInvalid, "archive_invalid"},
    ErrorCodeName{ErrorCode::kArchiveMember, "archive_member"},
    ErrorCodeName{ErrorCode::kArchiveSeveral, "archive_several"},
    ErrorCodeName{ErrorCode::kArchiveEmpty, "archive_empty"},
    ErrorCodeName{ErrorCode::kObjectMissing, "object_missing"},
    ErrorCodeName{ErrorCode::kVolumeTooLarge, "volume_too_large"},
    ErrorCodeName{ErrorCode::kMeshScale, "mesh_scale"},
    ErrorCodeName{ErrorCode::kPointsTooFew, "points_too_few"},
    ErrorCodeName{ErrorCode::kClaInvalid, "cla_invalid"},
    ErrorCodeName{ErrorCode::kClaUnknownModel, "cla_unknown_model"},
    ErrorCodeName{ErrorCode::kSegInvalid, "seg_invalid"},
    ErrorCodeName{ErrorCode::kIndexNotFound, "index_not_found"},
    ErrorCodeName{ErrorCode::kIndexForeign, "index_foreign"},
    ErrorCodeName{ErrorCode::kIndexNewer, "index_newer"},
    ErrorCodeName{ErrorCode::kIndexCorrupt, "index_corrupt"},
    ErrorCodeName{ErrorCode::kIndexBusy, "index_busy"},
    ErrorCodeName{ErrorCode::kIndexIo, "index_io"},
    ErrorCodeName{ErrorCode::kIndexParameters, "index_parameters"},
    ErrorCodeName{ErrorCode::kModelNotFound, "model_not_found"},
    ErrorCodeName{ErrorCode::kEvaluationNotFound, "evaluation_not_found"},
    ErrorCodeName{ErrorCode::kIndexReplaced, "index_replaced"},
    ErrorCodeName{ErrorCode::kUploadAbandoned, "upload_abandoned"},
    ErrorCodeName{ErrorCode::kPruneRefused, "prune_refused"},
};

static_assert(
    [] {
        for (std::size_t i = 0; i < kErrorCodeNames.size(); ++i) {
            if (static_cast<std::size_t>(kErrorCodeNames[i].code) != i) return false;
        }
        return kErrorCodeNames.size() == static_cast<std::size_t>(ErrorCode::kPruneRefused) + 1;
    }(),
    "every error code has its name, in the order of the enumeration");

constexpr std::string_view to_string(ErrorCode code) {
    return kErrorCodeNames[static_cast<std::size_t>(code)].name;
}

}  // namespace ossuary
