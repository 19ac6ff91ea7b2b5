// Feeds arbitrary bytes to the reader of OBJ files, and its meshes to what inspects and repairs
// them.

#include "engine/mesh/read_obj.h"

#include "tests/fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ossuary::fuzz::check_reader(ossuary::mesh::read_obj, data, size);
    return 0;
}
