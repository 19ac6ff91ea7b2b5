#include "index/thumbnail/ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>
#include <utility>

namespace ossuary::index {
namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using Scene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

Error embree_error(RTCError code, const char* doing) {
    const bool memory = code == RTC_ERROR_OUT_OF_MEMORY;
    return {memory ? ErrorCode::kOutOfMemory : ErrorCode::kInternal,
            std::string("Embree failed ") + doing + ", error " + std::to_string(code)};
}

}  // namespace

struct RayScene::Handles {
    Device device;
    Scene scene;  // released before its device
};

RayScene::RayScene(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&& other) noexcept = default;
RayScene& RayScene::operator=(RayScene&& other) noexcept = default;

Result<RayScene> RayScene::build(std::span<const Vec3f> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> triangles) {
    auto handles = std::make_unique<Handles>();
    // One thread: whoever draws many thumbnails has its own.
    handles->device.reset(rtcNewDevice("threads=1,set_affinity=0"));
    const RTCDevice device = handles->device.get();
    if (device == nullptr) return embree_error(rtcGetDeviceError(nullptr), "to start");
    handles->scene.reset(rtcNewScene(device));
    const RTCScene scene = handles->scene.get();
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const points = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), vertices.size()));
    auto* const corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), triangles.size()));
    if (points != nullptr && corners != nullptr) {
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            for (int axis = 0; axis < 3; ++axis)
                points[3 * v + std::size_t(axis)] = vertices[v][axis];
        }
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            std::copy(triangles[t].begin(), triangles[t].end(), corners + 3 * t);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        // Without this flag rays slip through the seams between triangles.
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene);
    }
    rtcReleaseGeometry(geometry);
    if (const RTCError failure = rtcGetDeviceError(device); failure != RTC_ERROR_NONE) {
        return embree_error(failure, "to build a scene");
    }
    return RayScene(std::move(handles));
}

void RayScene::first_hits(std::span<const Vec3f> origins, std::span<RayHit> hits) const {
    assert(origins.size() == hits.size());
    constexpr std::size_t kPacket = 4;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t first = 0; first < origins.size(); first += kPacket) {
        alignas(16) std::array<int, kPacket> valid{};
        alignas(16) RTCRayHit4 packet{};
        const std::size_t count = std::min(kPacket, origins.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            valid[i] = -1;
            packet.ray.org_x[i] = origins[first + i].x();
            packet.ray.org_y[i] = origins[first + i].y();
            packet.ray.org_z[i] = origins[first + i].z();
            packet.ray.dir_z[i] = -1.0f;
            packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
            packet.ray.mask[i] = 0xFFFFFFFFu;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect4(valid.data(), handles_->scene.get(), &context, &packet);
        for (std::size_t i = 0; i < count; ++i) {
            const bool met = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
            hits[first + i] =
                met ? RayHit{packet.hit.primID[i], packet.hit.u[i], packet.hit.v[i]} : RayHit{};
        }
    }
}

}  // namespace ossuary::index
