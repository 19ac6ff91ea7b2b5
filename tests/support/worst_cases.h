#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::test {

/// A model that makes some stage work as hard as it can. The same size gives the same model on
/// every machine.
struct WorstCase {
    std::string_view name;
    std::string_view what;
    std::size_t full;   ///< the size that is measured (docs/benchmarks/worst_cases.csv)
    std::size_t small;  ///< the size that tests run on
    /// @param size  what it counts is the case's own: `what` says so
    mesh::TriangleMesh (*build)(std::size_t size);
};

std::span<const WorstCase> worst_cases();

/// @pre there is one
const WorstCase& worst_case(std::string_view name);

}  // namespace ossuary::test
