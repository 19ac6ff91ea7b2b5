#include "engine/voxel/line_depths.h"

#include <algorithm>
#include <limits>

#include "engine/voxel/crossing_finder.h"

namespace ossuary::voxel {

LineDepths::LineDepths(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
                       const LineDirection& direction, CastMeter& meter) {
    struct Place {
        std::int16_t u, v;
        std::int32_t depth;
    };
    std::vector<Place> places;
    places.reserve(triangles.size());
    std::int32_t u1 = std::numeric_limits<std::int32_t>::min(), v1 = u1;
    u0_ = v0_ = std::numeric_limits<std::int32_t>::max();
    CrossingFinder(mesh, direction, meter)
        .find(triangles, [&](std::int32_t u, std::int32_t v, std::int32_t depth, std::uint32_t,
                             bool) {
            places.push_back({static_cast<std::int16_t>(u), static_cast<std::int16_t>(v), depth});
            u0_ = std::min(u0_, u);
            v0_ = std::min(v0_, v);
            u1 = std::max(u1, u);
            v1 = std::max(v1, v);
        });
    if (places.empty() || meter.over()) return;
    width_ = static_cast<std::size_t>(u1 - u0_ + 1);
    const std::size_t lines = width_ * static_cast<std::size_t>(v1 - v0_ + 1);
    const auto line_of = [&](const Place& place) {
        return static_cast<std::size_t>(place.v - v0_) * width_ +
               static_cast<std::size_t>(place.u - u0_);
    };
    // For a while, begin_[line + 1] is where the line goes on.
    begin_.assign(lines + 2, 0);
    for (const Place& place : places) ++begin_[line_of(place) + 2];
    for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    depths_.resize(places.size());
    for (const Place& place : places) depths_[begin_[line_of(place) + 1]++] = place.depth;
    begin_.pop_back();
    for (std::size_t line = 0; line < lines; ++line) {
        std::sort(depths_.begin() + begin_[line], depths_.begin() + begin_[line + 1]);
    }
}

}  // namespace ossuary::voxel
