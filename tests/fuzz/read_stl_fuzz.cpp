// Feeds arbitrary bytes to the reader of STL files, and its meshes to what inspects and repairs
// them.

#include "engine/mesh/read_stl.h"

#include "tests/fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ossuary::fuzz::check_reader(ossuary::mesh::read_stl, data, size);
    return 0;
}
