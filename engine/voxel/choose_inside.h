#pragma once

#include <limits>
#include <optional>
#include <set>
#include <stop_token>
#include <string>

#include "engine/core/result.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_surface.h"

namespace ossuary::voxel {

/// Which values are inside.
struct Inside {
    enum class Kind {
        kLabel,  ///< `value` alone
        kMask,   ///< all but `value`
        kLevel,  ///< `value` and above
    };
    Kind kind = Kind::kLevel;
    double value = 0.0;
    std::string reason;  ///< for people; empty where someone has said so
    double least = 0.0;  ///< of the volume's finite values
    double greatest = 0.0;
    std::size_t not_finite = 0;  ///< voxels

    [[nodiscard]] bool has(double number) const {
        switch (kind) {
            case Kind::kLabel:
                return number == value;
            case Kind::kMask:
                return number != value;
            case Kind::kLevel:
                return number >= value;
        }
        return false;
    }
};

/// See volume_surface. Errors: solid_empty (no finite value), invalid_argument, cancelled.
Result<Inside> choose_inside(const Volume& volume, const InsideOptions& options,
                             const std::stop_token& stop);

}  // namespace ossuary::voxel
