#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "engine/mesh/triangle_mesh.h"
#include "index/model.h"
#include "index/searcher.h"

namespace ossuary::index {

/// A model that is searched with and kept, so that of it, too, everything can be answered that an
/// index answers of its models. What takes time and may never be asked for is made at the first
/// call and kept. Safe to use from several threads at once.
class QueryModel {
public:
    /// @param mesh  as it was read
    /// @param warnings  of reading it
    QueryModel(std::string name, mesh::TriangleMesh mesh, std::vector<mesh::MeshWarning> warnings,
               const FileFrame& frame, DescribedQuery described);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const mesh::TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] const DescribedQuery& described() const { return described_; }
    /// Those of reading it before those of describing it.
    [[nodiscard]] const std::vector<mesh::MeshWarning>& warnings() const { return warnings_; }
    [[nodiscard]] const Box3& bounds() const { return bounds_; }
    [[nodiscard]] const FileFrame& frame() const { return frame_; }

    /// Which way it stands: as its file says, else as its shape suggests. Errors: cancelled.
    Result<Up> up(const std::stop_token& stop = {});

    /// At most about 2000 triangles of what was described. Errors: cancelled.
    Result<PreviewMesh> preview(const std::stop_token& stop = {});
    /// What is described, as it is looked for as a part. The reference lasts as long as this.
    const registration::PieceQuery& piece();
    /// Errors: those of segment_model.
    Result<ModelSegments> segments(const std::stop_token& stop = {});

    /// About the memory that it takes, with what is yet to be made: meshes as they are, some
    /// hundred kilobytes for everything else.
    [[nodiscard]] std::size_t bytes() const;

private:
    Result<mesh::TriangleMesh> coarse(const std::stop_token& stop) OSSUARY_REQUIRES(mutex_);

    const std::string name_;
    const mesh::TriangleMesh mesh_;
    const DescribedQuery described_;
    const std::vector<mesh::MeshWarning> warnings_;
    const Box3 bounds_;
    const FileFrame frame_;
    Mutex mutex_;
    std::optional<mesh::TriangleMesh> coarse_ OSSUARY_GUARDED_BY(mutex_);
    std::optional<registration::PieceQuery> piece_ OSSUARY_GUARDED_BY(mutex_);
    std::optional<ModelSegments> segments_ OSSUARY_GUARDED_BY(mutex_);
};

}  // namespace ossuary::index
