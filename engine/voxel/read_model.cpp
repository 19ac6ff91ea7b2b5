#include "engine/voxel/read_model.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/inflate.h"
#include "engine/core/whole_file.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/mesh_builder.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_surface.h"

namespace ossuary::voxel {
namespace {

/// Files with faces of fewer than three corners hold lines, and files without vertices nothing.
bool is_point_set(const mesh::TriangleMesh& mesh) {
    return mesh.face_count == 0 && !mesh.vertices.empty();
}

/// As read_mesh holds the meshes of files.
Result<void> check_scale(const mesh::TriangleMesh& mesh, const mesh::ReadMeshOptions& options) {
    const Box3 bounds = mesh::measure(mesh).bounds;
    const double largest =
        std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    const double extent = bounds.sizes().maxCoeff();
    if (largest <= options.max_coordinate && extent >= options.min_extent) return {};
    return {ErrorCode::kMeshScale,
            "expected coordinates of at most " + mesh::number_text(options.max_coordinate) +
                " and an extent of at least " + mesh::number_text(options.min_extent) + ", found " +
                mesh::number_text(largest) + " and " + mesh::number_text(extent)};
}

/// A surface that we have made in the place of what a file holds.
Result<mesh::ReadMeshResult> made(mesh::TriangleMesh mesh, std::vector<mesh::MeshWarning> warnings,
                                  const ReadModelOptions& options) {
    if (const Result<void> checked = check_scale(mesh, options.mesh); !checked) {
        return checked.error();
    }
    for (mesh::MeshWarning& warning : mesh::surface_warnings(mesh)) {
        warnings.push_back(std::move(warning));
    }
    return mesh::ReadMeshResult{std::move(mesh), std::move(warnings)};
}

Result<mesh::ReadMeshResult> wrap(mesh::ReadMeshResult read, const ReadModelOptions& options,
                                  const std::stop_token& stop) {
    Result<WrappedPoints> wrapped = wrap_points(read.mesh.vertices, options.wrap, stop);
    if (!wrapped) return wrapped.error();
    // What a surface without triangles is odd about.
    std::erase_if(read.warnings, [](const mesh::MeshWarning& warning) {
        return warning.code == "no_triangles" || warning.code == "unreferenced_vertices";
    });
    const std::size_t points = read.mesh.vertices.size();
    read.warnings.push_back({"points_wrapped", points,
                             mesh::plural(points, "point") + " without faces, " +
                                 mesh::number_text(wrapped->spacing) +
                                 " apart, taken for those of a surface; gaps up to " +
                                 mesh::number_text(2 * wrapped->radius) + " closed"});
    if (wrapped->stray_points > 0) {
        read.warnings.push_back(
            {"stray_points", wrapped->stray_points,
             mesh::plural(wrapped->stray_points, "point") + " far from all others left out"});
    }
    return made(std::move(wrapped->mesh), std::move(read.warnings), options);
}

/// The name of the file stands before messages that do not begin with it.
Result<mesh::ReadMeshResult> named(Result<mesh::ReadMeshResult> result, std::string_view name) {
    if (result) return result;
    return {result.error().code, std::string(name) + ": " + result.error().message};
}

Result<mesh::ReadMeshResult> read_unpacked(std::string_view bytes, std::string_view name,
                                           const ReadModelOptions& options,
                                           const std::stop_token& stop) {
    if (looks_like_volume(bytes)) {
        const Result<Volume> volume = read_volume(bytes, name, {}, stop);
        if (!volume) return volume.error();
        Result<VolumeSurface> surface = volume_surface(*volume, {.inside = options.inside}, stop);
        if (!surface) return named(surface.error(), name);
        return named(made(std::move(surface->mesh), std::move(surface->warnings), options), name);
    }
    Result<mesh::ReadMeshResult> read = mesh::read_mesh(bytes, name, options.mesh, stop);
    if (!read || !is_point_set(read->mesh)) return read;
    return named(wrap(*std::move(read), options, stop), name);
}

}  // namespace

Result<mesh::ReadMeshResult> read_model(const std::filesystem::path& path,
                                        const ReadModelOptions& options,
                                        const std::stop_token& stop) {
    const Result<WholeFile> file = read_whole_file(path, options.mesh.max_bytes);
    if (!file) return file.error();
    return read_model(file->view(), path.string(), options, stop);
}

Result<mesh::ReadMeshResult> read_model(std::string_view bytes, std::string_view name,
                                        const ReadModelOptions& options,
                                        const std::stop_token& stop) {
    if (!looks_like_gzip(bytes)) return read_unpacked(bytes, name, options, stop);
    const Result<WholeFile> unpacked = gunzip(bytes, name, {}, stop);
    if (!unpacked) return unpacked.error();
    return read_unpacked(unpacked->view(), name, options, stop);
}

}  // namespace ossuary::voxel
