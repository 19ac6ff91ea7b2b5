#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/voxel/read_model.h"
#include "index/reader_process.h"

namespace ossuary::index {

/// Gives a file of at most so many bytes that a model refers to, by the name that the model gives.
/// Errors: gltf_buffer, with the reason.
using Companions =
    std::function<Result<OwnedDescriptor>(std::string_view name, std::uint64_t max_bytes)>;

/// A model file in memory.
struct ModelBytes {
    WholeFile bytes;
    std::string name;  ///< stands for the file in messages
    /// Where it lies; not to be asked once the reader that opened it has gone.
    Companions companions;
    std::string object;  ///< of the file, that is meant (ModelPlace); empty = all of it
};

/// The models in a ZIP archive.
struct ArchiveModels {
    /// Their names (mesh::is_model_file), in the archive's order; hidden ones are left out.
    std::vector<std::string> names;
    bool is_package = false;  ///< a file of another format, as 3MF is, and so without models
};

/// Reads model files of every format that is known: those that this project has strict readers for
/// within the program, the others in processes of their own that are held within limits
/// (`ossuary-read`, beside the program), ZIP archives too. A few of those are kept for the next
/// files. May be used from many threads at once.
class ModelReader {
public:
    struct Options {
        ReaderLimits limits;
        /// Where `ossuary-read` is; empty = beside the running program, else in
        /// `../libexec/ossuary`.
        std::filesystem::path program;
        std::size_t kept = 4;  ///< processes that wait for work
    };

    ModelReader();
    explicit ModelReader(Options options);

    /// The bytes of a model, as place_of names it; an archive of one model is that model.
    /// Errors: file_not_found, file_unreadable, file_too_large, archive_invalid, archive_member,
    /// archive_empty, archive_several (with what there is), format_unsupported for an archive in an
    /// archive; those of the process.
    Result<ModelBytes> open(const std::filesystem::path& path, std::uint64_t max_bytes,
                            const std::stop_token& stop = {});

    /// The names of the objects of a model file (mesh::object_names); fewer than two where it is
    /// one model. The file is kept for the next call that asks for an object of it. Errors: those
    /// of read.
    Result<std::vector<std::string>> list_objects(const std::filesystem::path& path,
                                                  const voxel::ReadModelOptions& options = {},
                                                  const std::stop_token& stop = {});

    /// What a ZIP archive holds.
    /// Errors: file_not_found, file_unreadable, archive_invalid; those of the process.
    Result<ArchiveModels> list_archive(const std::filesystem::path& archive,
                                       const std::stop_token& stop = {});

    /// Reads a model, with the files that it refers to in and below its folder.
    /// Errors: those of open and of voxel::read_model; object_missing; for the others
    /// three_mf_invalid, three_mf_extension, gltf_invalid, gltf_extension, gltf_buffer,
    /// scene_invalid, model_…; reader_time, reader_memory and reader_crashed where a file cost its
    /// reader's life; reader_unavailable.
    Result<mesh::ReadMeshResult> read(const std::filesystem::path& path,
                                      const voxel::ReadModelOptions& options = {},
                                      const std::stop_token& stop = {});

    /// The same from memory.
    struct Source {
        std::string_view bytes;
        std::string_view name;         ///< stands for the file in messages
        Companions companions = {};    ///< none = it stands alone
        std::string_view object = {};  ///< empty = all of it
    };
    Result<mesh::ReadMeshResult> read(const Source& source,
                                      const voxel::ReadModelOptions& options = {},
                                      const std::stop_token& stop = {});

    /// Whether a format is read in a process of its own.
    [[nodiscard]] static bool is_foreign(mesh::ModelFormat format);

private:
    using Archive = std::shared_ptr<const OwnedDescriptor>;

    Result<std::unique_ptr<ReaderProcess>> take();
    void give_back(std::unique_ptr<ReaderProcess> process);
    Result<ArchiveModels> models_in(const Archive& archive, const std::stop_token& stop);
    Result<WholeFile> unpack(const Archive& archive, const UnpackRequest& request,
                             const std::stop_token& stop);
    Result<ModelBytes> open_member(const Archive& archive, std::string_view name,
                                   const UnpackRequest& request, const std::stop_token& stop);
    using WholeModel = std::shared_ptr<const mesh::ReadMeshResult>;
    Result<WholeModel> read_to_split(const Source& source, const voxel::ReadModelOptions& options,
                                     const std::stop_token& stop);
    Result<mesh::ReadMeshResult> read_object(const Source& source,
                                             const voxel::ReadModelOptions& options,
                                             const std::stop_token& stop);
    Result<ModelBytes> open_only_model(const Archive& archive, std::string_view name,
                                       std::uint64_t max_bytes, const std::stop_token& stop);

    const Options options_;
    Mutex mutex_;
    std::vector<std::unique_ptr<ReaderProcess>> waiting_ OSSUARY_GUARDED_BY(mutex_);
    /// The file that an object was asked of last, by its content hash.
    std::string split_hash_ OSSUARY_GUARDED_BY(mutex_);
    WholeModel split_ OSSUARY_GUARDED_BY(mutex_);
};

/// Opens a file that a model refers to, by a relative name that does not lead out of `folder`, not
/// by a link either. Errors: gltf_buffer.
Result<OwnedDescriptor> open_beneath(const std::filesystem::path& folder, std::string_view name,
                                     std::uint64_t max_bytes);

}  // namespace ossuary::index
