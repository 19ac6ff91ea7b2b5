#pragma once

#include "engine/mesh/triangle_mesh.h"
#include "tests/support/shapes.h"

namespace ossuary::registration {

/// A body without any symmetry: a trunk with two limbs and a shoulder.
inline mesh::TriangleMesh odd_body() {
    mesh::TriangleMesh body = test::capsule_mesh({0, 0, 0}, {10, 0, 0}, 1.0);
    body = test::merged(body, test::capsule_mesh({2, 0, 0}, {2, 5, 1}, 0.7));
    body = test::merged(body, test::capsule_mesh({9, 0, 0}, {8, 1, 4}, 0.5));
    return test::merged(body, test::icosphere_mesh({0, 0, 1}, 1.6, 3));
}

}  // namespace ossuary::registration
