// Feeds arbitrary bytes to the reader of points as text, as it is and by way of what tells it from
// other formats.

#include "engine/mesh/read_xyz.h"

#include "tests/fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    static_cast<void>(ossuary::mesh::looks_like_xyz(bytes));
    static_cast<void>(ossuary::mesh::is_xyz_rather_than_off(bytes));
    ossuary::fuzz::check_reader(ossuary::mesh::read_xyz, data, size);
    return 0;
}
