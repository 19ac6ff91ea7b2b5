#include "index/material_libraries.h"

#include <string>
#include <vector>

#include "engine/mesh/obj_materials.h"
#include "engine/mesh/text_scanner.h"
#include "index/companion_hash.h"

namespace ossuary::index {

void colour_by_libraries(mesh::ReadMeshResult& read, std::string_view obj,
                         const Companions& companions) {
    constexpr std::uint64_t kMostBytes = 16 << 20;
    const std::vector<std::string> names = mesh::material_libraries(obj);
    if (names.empty() || !companions) return;
    mesh::MaterialColours colours;
    bool found = false;
    for (const std::string& name : names) {
        const auto file = companions(name, kMostBytes);
        if (!file) continue;
        const auto library = read_companion(*file);
        if (!library) continue;
        found = true;
        colours.merge(mesh::read_material_colours(library->view()));
    }
    mesh::colour_by_materials(read, colours);
    if (found) return;
    read.warnings.push_back({"material_library_missing", 1,
                             "colours of materials left out: expected the material library " +
                                 mesh::quoted_token(names.front().substr(0, 200)) +
                                 " in the folder of the file or below, found none"});
}

}  // namespace ossuary::index
