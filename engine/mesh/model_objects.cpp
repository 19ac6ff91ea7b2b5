#include "engine/mesh/model_objects.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "engine/core/text.h"

namespace ossuary::mesh {
namespace {

std::string clean_name(std::string_view name, std::size_t number) {
    constexpr std::size_t kLongest = 200;  // bytes
    std::string clean = valid_utf8(name);
    std::erase_if(clean, [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; });
    clean.resize(cut_utf8(clean, kLongest).size());
    return clean.empty() ? "object " + std::to_string(number) : clean;
}

}  // namespace

std::vector<ModelObject> objects_between(const std::vector<ObjectMark>& marks,
                                         const TriangleMesh& mesh) {
    const auto first_triangle_of = [&](std::uint32_t face) {
        const auto& faces = mesh.face_of_triangle;
        return static_cast<std::uint32_t>(std::lower_bound(faces.begin(), faces.end(), face) -
                                          faces.begin());
    };
    std::vector<ModelObject> objects;
    const auto add = [&](const std::string& name, std::uint32_t first, std::uint32_t end) {
        if (end > first) objects.push_back({name, first, end - first});
    };
    const auto all = static_cast<std::uint32_t>(mesh.triangles.size());
    add("", 0, marks.empty() ? all : first_triangle_of(marks.front().first_face));
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const std::uint32_t end =
            i + 1 < marks.size() ? first_triangle_of(marks[i + 1].first_face) : all;
        add(marks[i].name, first_triangle_of(marks[i].first_face), end);
    }
    return objects;
}

std::vector<std::string> object_names(const std::vector<ModelObject>& objects) {
    std::vector<std::string> names;
    std::unordered_set<std::string> taken;
    std::unordered_map<std::string, std::size_t> copies;
    for (const ModelObject& object : objects) {
        const std::string clean = clean_name(object.name, names.size() + 1);
        std::string name = clean;
        while (!taken.insert(name).second) {
            name =
                clean + " (" + std::to_string(++copies.try_emplace(clean, 1).first->second) + ")";
        }
        names.push_back(std::move(name));
    }
    return names;
}

TriangleMesh object_mesh(const TriangleMesh& mesh, const ModelObject& object) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    const auto first = mesh.triangles.begin() + object.first_triangle;
    TriangleMesh part;
    part.triangles.assign(first, first + object.triangles);
    if (!mesh.corner_colours.empty()) {
        const auto colours = mesh.corner_colours.begin() + object.first_triangle;
        part.corner_colours.assign(colours, colours + object.triangles);
    }
    std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
    for (const TriangleMesh::Triangle& triangle : part.triangles) {
        for (const std::uint32_t vertex : triangle) number[vertex] = 0;
    }
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == kNone) continue;
        number[v] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[v]);
    }
    for (TriangleMesh::Triangle& triangle : part.triangles) {
        for (std::uint32_t& vertex : triangle) vertex = number[vertex];
    }
    std::uint32_t last = kNone;
    for (std::uint32_t t = 0; t < object.triangles; ++t) {
        const std::uint32_t face = mesh.face_of_triangle[object.first_triangle + t];
        part.face_count += face != last ? 1 : 0;
        part.face_of_triangle.push_back(part.face_count - 1);
        last = face;
    }
    return part;
}

}  // namespace ossuary::mesh
