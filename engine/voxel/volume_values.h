#pragma once

#include <cassert>
#include <cstdint>
#include <stop_token>

#include "engine/mesh/load_number.h"
#include "engine/voxel/volume.h"

namespace ossuary::voxel {

/// Calls `visit(voxel, value)` for each voxel in the file's order, where `value` is what the
/// stored number stands for; false where it was stopped before the end.
template <typename Stored, typename Visit>
bool visit_stored(const Volume& volume, const std::stop_token& stop, Visit&& visit) {
    const char* at = volume.values.data();
    // Axes from the slowest to the fastest.
    const Vec3i order = volume.last_axis_fastest ? Vec3i(0, 1, 2) : Vec3i(2, 1, 0);
    Vec3i voxel = Vec3i::Zero();
    int& slow = voxel[order[0]];
    int& middle = voxel[order[1]];
    int& fast = voxel[order[2]];
    for (slow = 0; slow < volume.size[order[0]]; ++slow) {
        for (middle = 0; middle < volume.size[order[1]]; ++middle) {
            if (middle % 64 == 0 && stop.stop_requested()) return false;
            for (fast = 0; fast < volume.size[order[2]]; ++fast) {
                const auto stored =
                    static_cast<double>(mesh::load_number<Stored>(at, volume.order));
                at += sizeof(Stored);
                visit(voxel, volume.slope * stored + volume.intercept);
            }
        }
    }
    return true;
}

template <typename Visit>
bool visit_values(const Volume& volume, const std::stop_token& stop, Visit&& visit) {
    switch (volume.type) {
        case VoxelType::kUint8:
            return visit_stored<std::uint8_t>(volume, stop, visit);
        case VoxelType::kInt8:
            return visit_stored<std::int8_t>(volume, stop, visit);
        case VoxelType::kUint16:
            return visit_stored<std::uint16_t>(volume, stop, visit);
        case VoxelType::kInt16:
            return visit_stored<std::int16_t>(volume, stop, visit);
        case VoxelType::kUint32:
            return visit_stored<std::uint32_t>(volume, stop, visit);
        case VoxelType::kInt32:
            return visit_stored<std::int32_t>(volume, stop, visit);
        case VoxelType::kUint64:
            return visit_stored<std::uint64_t>(volume, stop, visit);
        case VoxelType::kInt64:
            return visit_stored<std::int64_t>(volume, stop, visit);
        case VoxelType::kFloat32:
            return visit_stored<float>(volume, stop, visit);
        case VoxelType::kFloat64:
            return visit_stored<double>(volume, stop, visit);
    }
    assert(false);
    return false;
}

}  // namespace ossuary::voxel
