// Feeds arbitrary bytes to the mesh reader, whatever the format, and its meshes to what inspects
// and repairs them.

#include "engine/mesh/read_mesh.h"

#include "tests/fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ossuary::fuzz::check_reader(ossuary::mesh::read_mesh, data, size);
    return 0;
}
