#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string_view>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "index/reader_process.h"

namespace ossuary::index {

/// Reads model files of every format that is known: those that this project has strict readers for
/// within the program, the others in processes of their own that are held within limits
/// (`ossuary-read`, beside the program). A few of those are kept for the next files. May be used
/// from many threads at once.
class ModelReader {
public:
    struct Options {
        ReaderLimits limits;
        /// Where `ossuary-read` is; empty = beside the running program.
        std::filesystem::path program;
        std::size_t kept = 4;  ///< processes that wait for work
    };

    ModelReader();
    explicit ModelReader(Options options);

    /// Reads a file, with those that it refers to in and below its folder.
    /// Errors: those of voxel::read_model; for the others three_mf_invalid, three_mf_extension,
    /// gltf_invalid, gltf_extension, gltf_buffer, scene_invalid, model_…; reader_time,
    /// reader_memory and reader_crashed where a file cost its reader's life; reader_unavailable.
    Result<mesh::ReadMeshResult> read(const std::filesystem::path& path,
                                      const mesh::ReadMeshOptions& caps = {},
                                      const std::stop_token& stop = {});

    /// The same from memory.
    struct Source {
        std::string_view bytes;
        std::string_view name;         ///< stands for the file in messages
        std::filesystem::path folder;  ///< of files that it refers to; empty = there are none
    };
    Result<mesh::ReadMeshResult> read(const Source& source, const mesh::ReadMeshOptions& caps = {},
                                      const std::stop_token& stop = {});

    /// Whether a format is read in a process of its own.
    [[nodiscard]] static bool is_foreign(mesh::ModelFormat format);

private:
    Result<std::unique_ptr<ReaderProcess>> take();
    void give_back(std::unique_ptr<ReaderProcess> process);

    const Options options_;
    Mutex mutex_;
    std::vector<std::unique_ptr<ReaderProcess>> waiting_ OSSUARY_GUARDED_BY(mutex_);
};

/// Opens a file that a model refers to, by a relative name that does not lead out of `folder`, not
/// by a link either. Errors: gltf_buffer.
Result<OwnedDescriptor> open_beneath(const std::filesystem::path& folder, std::string_view name,
                                     std::uint64_t max_bytes);

}  // namespace ossuary::index
