// Feeds arbitrary bytes to the reader of material libraries and to what looks for their names in
// OBJ files.

#include "engine/mesh/obj_materials.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ossuary;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto colours = mesh::read_material_colours(bytes);
    fuzz::require(colours.size() <= size);
    const auto names = mesh::material_libraries(bytes);
    for (const std::string& name : names) {
        fuzz::require(!name.empty() && name.find_first_of("\\\r\n") == std::string::npos);
        fuzz::require(std::count(names.begin(), names.end(), name) == 1);
    }
    return 0;
}
