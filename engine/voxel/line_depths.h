#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/voxel/cast_meter.h"
#include "engine/voxel/grid_mesh.h"
#include "engine/voxel/ray_columns.h"

namespace ossuary::voxel {

/// The depths at which lines cross triangles: cast_lines for those who need neither parts nor ways.
class LineDepths {
public:
    /// Not complete where the meter says so.
    LineDepths(const GridMesh& mesh, std::span<const std::uint32_t> triangles,
               const LineDirection& direction, CastMeter& meter);

    /// Calls visit(u, v, depths) for each line that crosses something, with its depths in order.
    template <typename Visit>
    void for_each_line(Visit&& visit) const {
        for (std::size_t line = 0; line + 1 < begin_.size(); ++line) {
            if (begin_[line] == begin_[line + 1]) continue;
            visit(u0_ + static_cast<std::int32_t>(line % width_),
                  v0_ + static_cast<std::int32_t>(line / width_),
                  std::span(depths_).subspan(begin_[line], begin_[line + 1] - begin_[line]));
        }
    }

private:
    std::int32_t u0_ = 0, v0_ = 0;      ///< of line 0; u fastest
    std::size_t width_ = 1;             ///< lines along u
    std::vector<std::int32_t> depths_;  ///< in fixed point, rounded up
    std::vector<std::uint32_t> begin_;  ///< of each line, and one more, where the depths end
};

}  // namespace ossuary::voxel
