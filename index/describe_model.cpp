#include "index/describe_model.h"

#include <fmt/format.h>

#include <exception>
#include <new>

#include "engine/core/inflate.h"
#include "engine/descriptor/describe.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/registration/piece_search.h"
#include "engine/voxel/read_model.h"
#include "index/companion_hash.h"
#include "index/content_hash.h"
#include "index/model_segments.h"
#include "index/preview.h"
#include "index/round_skeleton.h"
#include "index/turn_model.h"
#include "index/upright.h"

namespace ossuary::index {

namespace {

constexpr std::size_t kPreviewTriangles = 2000;

Error describing_cancelled(std::string_view name) {
    return {ErrorCode::kCancelled, std::string(name) + ": describing it was cancelled"};
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
    descriptor::DescribeOptions describing = describe_options(parameters);
    describing.jobs = 1;  // whoever describes many models has threads for them
    auto description = descriptor::describe(mesh, describing, stop);
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
    model.skeleton = round_skeleton(std::move(description->skeleton));
    const mesh::TriangleMesh& body = description->body.of(mesh);
    const mesh::TriangleMesh coarse =
        mesh::decimate(body, {.max_triangles = kPreviewTriangles}, stop);
    model.preview = make_preview(coarse);
    model.features = registration::whole_features(mesh_of(model.preview));
    if (stop.stop_requested()) return describing_cancelled(source.name);
    model.summary.frame = frame_of(*read);
    const Up found = model.summary.frame.up ? *model.summary.frame.up : find_up(coarse);
    model.summary.orientation = {source.up ? *source.up : found, source.up.has_value()};
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

FileFrame frame_of(const mesh::ReadMeshResult& read) {
    FileFrame frame{read.metres_per_unit, {}};
    if (!read.up) return frame;
    switch (*read.up) {
        case mesh::UpAxis::kX:
            frame.up = Up::kX;
            break;
        case mesh::UpAxis::kY:
            frame.up = Up::kY;
            break;
        case mesh::UpAxis::kZ:
            frame.up = Up::kZ;
            break;
    }
    return frame;
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

}  // namespace ossuary::index
