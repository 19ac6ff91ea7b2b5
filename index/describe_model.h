#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "index/model.h"
#include "index/model_reader.h"

namespace ossuary::index {

/// A model file.
struct ModelSource {
    std::string_view bytes;
    std::string_view name;      ///< stands for the file in messages
    std::optional<Up> up = {};  ///< as a person has said; none = the file's, or found
    /// Reads it; null = formats that are read within the program alone.
    ModelReader* reader = nullptr;
    Companions companions = {};        ///< files that it refers to; none = it stands alone
    std::string_view object = {};      ///< of the file, that is meant; empty = all of it
    voxel::InsideOptions inside = {};  ///< as a person has said of a volume
};

/// Tells models apart: content_hash of the file with those that it refers to (companion_hash.h) and
/// of the object, and for a volume (also within gzip data) of what was said to be inside it, if
/// anything was.
[[nodiscard]] std::string model_hash(const ModelSource& source);

/// From a model file to all that an index keeps of it. The summary's path, name and class are left
/// to the caller. What only viewers ask for may be missing, with a warning: the thumbnail, and the
/// parts (see add_segments).
/// Errors: those of ModelReader and describe, out_of_memory, internal; never an exception.
Result<NewModel> describe_model(const ModelSource& source, const IndexParameters& parameters,
                                std::stop_token stop = {});

/// What a file that has been read says of its unit and axes.
[[nodiscard]] FileFrame frame_of(const mesh::ReadMeshResult& read);

/// Cuts a described model into parts, the last and least needed stage of its description: where
/// that fails or `stop` is requested, the model gets the warning kSegmentsMissing instead.
/// @param coarse  the mesh of `model.preview`, at full precision
void add_segments(NewModel& model, const mesh::TriangleMesh& mesh, const mesh::TriangleMesh& coarse,
                  std::stop_token stop);

}  // namespace ossuary::index
