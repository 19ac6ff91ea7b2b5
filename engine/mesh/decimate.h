#pragma once

#include <cstddef>
#include <stop_token>

#include "engine/mesh/triangle_mesh.h"

namespace ossuary::mesh {

struct DecimateOptions {
    std::size_t max_triangles = 2000;
};

/// A preview of a model with at most `max_triangles` triangles and no unused vertex; deterministic.
/// Coincident vertices are welded and triangles without corners of their own dropped first; then
/// edges are collapsed by quadric error (Garland and Heckbert, Surface Simplification Using Quadric
/// Error Metrics, 1997), and where that cannot reach the bound (soups of many small pieces),
/// vertices are clustered. Triangles may be turned over so that neighbours agree.
/// `face_of_triangle` of the result numbers its own triangles; its colours are those that the mesh
/// has there. Takes some tenths of a second for a
/// million triangles. Once `stop` is requested the result may be finer than asked for.
TriangleMesh decimate(const TriangleMesh& mesh, const DecimateOptions& options = {},
                      const std::stop_token& stop = {});

}  // namespace ossuary::mesh
