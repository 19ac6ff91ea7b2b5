#include "index/describe_model.h"

#include <fmt/format.h>

#include <exception>
#include <new>

#include "engine/core/inflate.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/voxel/read_model.h"
#include "index/companion_hash.h"
#include "index/content_hash.h"
#include "index/model_segments.h"
#include "index/turn_model.h"
#include "index/upright.h"

namespace ossuary::index {

namespace {

constexpr std::size_t kPreviewTriangles = 2000;

Error describing_cancelled(std::string_view name) {
    return {ErrorCode::kCancelled, std::string(name) + ": describing it was cancelled"};
}

/// As the file says, else as the shape suggests.
Up up_of(const mesh::ReadMeshResult& read, const mesh::TriangleMesh& coarse) {
    if (read.up == mesh::UpAxis::kY) return Up::kY;
    if (read.up == mesh::UpAxis::kZ) return Up::kZ;
    return find_up(coarse);
}

Result<NewModel> describe_checked(const ModelSource& source, const IndexParameters& parameters,
                                  std::stop_token stop) {
    const voxel::ReadModelOptions options{.inside = source.inside};
    auto read =
        source.reader == nullptr
            ? voxel::read_model(source.bytes, source.name, options, stop)
            : source.reader->read({source.bytes, source.name, source.companions, source.object},
                                  options, stop);
    if (!read) return read.error();
    const mesh::TriangleMesh& mesh = read->mesh;
    if (stop.stop_requested()) return describing_cancelled(source.name);
    auto description = descriptor::describe(mesh, describe_options(parameters), stop);
    if (!description) return description.error();

    NewModel model;
    const mesh::MeshMeasures measures = mesh::measure(mesh);
    model.summary.content_hash = model_hash(source);
    model.summary.vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    model.summary.faces = mesh.face_count;
    model.summary.bounds = measures.bounds;
    model.summary.surface_area = measures.surface_area;
    model.summary.warnings = std::move(read->warnings);
    model.summary.warnings.insert(model.summary.warnings.end(), description->warnings.begin(),
                                  description->warnings.end());
    model.descriptor = std::move(description->descriptor);
    model.skeleton = std::move(description->skeleton);
    const mesh::TriangleMesh& body = description->body.of(mesh);
    const mesh::TriangleMesh coarse =
        mesh::decimate(body, {.max_triangles = kPreviewTriangles}, stop);
    model.preview = make_preview(coarse);
    if (stop.stop_requested()) return describing_cancelled(source.name);
    model.summary.orientation = {source.up ? *source.up : up_of(*read, coarse),
                                 source.up.has_value()};
    auto thumbnail = render_thumbnail(body, thumbnail_options(model.summary.orientation.up), stop);
    if (thumbnail) {
        model.thumbnail = *std::move(thumbnail);
    } else {
        model.summary.warnings.push_back({"thumbnail_missing", 1, thumbnail.error().message});
    }
    if (stop.stop_requested()) return describing_cancelled(source.name);
    add_segments(model, mesh, coarse, std::move(stop));
    return model;
}

}  // namespace

std::string model_hash(const ModelSource& source) {
    const voxel::InsideOptions& inside = source.inside;
    std::string hash = hash_with_companions(source.bytes, source.companions);
    if (!source.object.empty()) hash = object_hash(hash, source.object);
    const bool may_be_volume =
        voxel::looks_like_volume(source.bytes) || looks_like_gzip(source.bytes);
    if (inside == voxel::InsideOptions{} || !may_be_volume) return hash;
    return content_hash(inside.label ? fmt::format("{} label {}", hash, *inside.label)
                                     : fmt::format("{} threshold {}", hash, *inside.threshold));
}

Result<NewModel> describe_model(const ModelSource& source, const IndexParameters& parameters,
                                std::stop_token stop) {
    try {
        return describe_checked(source, parameters, stop);
    } catch (const std::bad_alloc&) {
        return {ErrorCode::kOutOfMemory, std::string(source.name) + ": not enough memory"};
    } catch (const std::exception& exception) {
        return {ErrorCode::kInternal, std::string(source.name) + ": " + exception.what()};
    }
}

void add_segments(NewModel& model, const mesh::TriangleMesh& mesh, const mesh::TriangleMesh& coarse,
                  std::stop_token stop) {
    auto segments = segment_model(mesh, coarse, model.skeleton, std::move(stop));
    if (segments) {
        model.segments = *std::move(segments);
    } else {
        model.summary.warnings.push_back(
            {std::string(kSegmentsMissing), 1, segments.error().message});
    }
}

PreviewMesh make_preview(const mesh::TriangleMesh& coarse) {
    PreviewMesh preview;
    const Box3 bounds = mesh::measure(coarse).bounds;
    if (!bounds.isEmpty()) preview.origin = bounds.center();
    preview.positions.reserve(coarse.vertices.size() * 3);
    for (const Vec3& vertex : coarse.vertices) {
        const Vec3 from_origin = vertex - preview.origin;
        for (const double coordinate : {from_origin.x(), from_origin.y(), from_origin.z()}) {
            preview.positions.push_back(static_cast<float>(coordinate));
        }
    }
    preview.triangles.reserve(coarse.triangles.size() * 3);
    for (const mesh::TriangleMesh::Triangle& triangle : coarse.triangles) {
        preview.triangles.insert(preview.triangles.end(), triangle.begin(), triangle.end());
    }
    return preview;
}

}  // namespace ossuary::index
