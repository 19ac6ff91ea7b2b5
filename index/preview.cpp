#include "index/preview.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/mesh/colours_on.h"
#include "engine/mesh/measures.h"
#include "index/grid_numbers.h"

namespace ossuary::index {
namespace {

using mesh::Colour;
using mesh::CornerColours;

void put(PreviewColours& colours, const Colour& colour) {
    colours.bytes.insert(colours.bytes.end(), colour.begin(), colour.end());
}

/// The colour of each vertex, where all triangles around agree on it.
std::optional<std::vector<Colour>> vertex_colours(const mesh::TriangleMesh& mesh) {
    std::vector<Colour> colours(mesh.vertices.size(), mesh::kPlainColour);
    std::vector<std::uint8_t> known(mesh.vertices.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[t][corner];
            const Colour& colour = mesh.corner_colours[t][corner];
            if (known[vertex] != 0 && colours[vertex] != colour) return {};
            known[vertex] = 1;
            colours[vertex] = colour;
        }
    }
    return colours;
}

/// In the form that takes the fewest bytes and says the same.
PreviewColours preview_colours(const mesh::TriangleMesh& mesh) {
    using Of = PreviewColours::Of;
    PreviewColours colours;
    if (mesh.corner_colours.empty()) return colours;
    const bool flat = mesh::has_flat_colours(mesh);
    const bool one = std::all_of(mesh.corner_colours.begin(), mesh.corner_colours.end(),
                                 [&](const auto& each) { return each == mesh.corner_colours[0]; });
    if (flat && one) {
        colours.of = Of::kModel;
        put(colours, mesh.corner_colours[0][0]);
    } else if (const auto of_vertices = vertex_colours(mesh)) {
        colours.of = Of::kVertices;
        for (const Colour& colour : *of_vertices) put(colours, colour);
    } else {
        colours.of = flat ? Of::kTriangles : Of::kCorners;
        for (const CornerColours& corners : mesh.corner_colours) {
            put(colours, corners[0]);
            if (flat) continue;
            put(colours, corners[1]);
            put(colours, corners[2]);
        }
    }
    return colours;
}

/// The multiples of a power of two that part a model's longest side in 8,192 to 16,384 steps: less
/// than an eighth of a pixel each where it fills a screen.
class PreviewGrid {
public:
    /// @param reach  the greatest of the coordinates
    explicit PreviewGrid(double reach) {
        if (reach > 0.0 && std::isfinite(reach)) exponent_ = std::ilogb(reach) - 12;
    }
    [[nodiscard]] float nearest(double coordinate) const {
        const double most = grid_number(0x7FFF, exponent_);
        return static_cast<float>(round_to_grid(std::clamp(coordinate, -most, most), exponent_));
    }

private:
    int exponent_ = 0;
};

/// @pre the colours fit the preview
std::vector<CornerColours> corner_colours(const PreviewMesh& preview) {
    using Of = PreviewColours::Of;
    std::vector<CornerColours> colours;
    if (preview.colours.of == Of::kNothing) return colours;
    for (std::size_t i = 0; i < preview.triangles.size(); ++i) {
        std::size_t which = 0;
        if (preview.colours.of == Of::kVertices) which = preview.triangles[i];
        if (preview.colours.of == Of::kTriangles) which = i / 3;
        if (preview.colours.of == Of::kCorners) which = i;
        if (i % 3 == 0) colours.emplace_back();
        std::copy_n(preview.colours.bytes.begin() + static_cast<std::ptrdiff_t>(3 * which), 3,
                    colours.back()[i % 3].begin());
    }
    return colours;
}

}  // namespace

PreviewMesh make_preview(const mesh::TriangleMesh& coarse) {
    PreviewMesh preview;
    const Box3 bounds = mesh::measure(coarse).bounds;
    if (!bounds.isEmpty()) preview.origin = bounds.center();
    const PreviewGrid grid(bounds.isEmpty() ? 0.0 : bounds.sizes().maxCoeff() / 2.0);
    preview.positions.reserve(coarse.vertices.size() * 3);
    for (const Vec3& vertex : coarse.vertices) {
        const Vec3 from_origin = vertex - preview.origin;
        for (const double coordinate : {from_origin.x(), from_origin.y(), from_origin.z()}) {
            preview.positions.push_back(grid.nearest(coordinate));
        }
    }
    preview.triangles.reserve(coarse.triangles.size() * 3);
    for (const mesh::TriangleMesh::Triangle& triangle : coarse.triangles) {
        preview.triangles.insert(preview.triangles.end(), triangle.begin(), triangle.end());
    }
    preview.colours = preview_colours(coarse);
    return preview;
}

mesh::TriangleMesh mesh_of(const PreviewMesh& preview) {
    mesh::TriangleMesh mesh;
    for (std::size_t i = 0; i + 2 < preview.positions.size(); i += 3) {
        mesh.vertices.push_back(preview.origin +
                                Vec3{static_cast<double>(preview.positions[i]),
                                     static_cast<double>(preview.positions[i + 1]),
                                     static_cast<double>(preview.positions[i + 2])});
    }
    for (std::size_t i = 0; i + 2 < preview.triangles.size(); i += 3) {
        mesh.face_of_triangle.push_back(mesh.face_count++);
        mesh.triangles.push_back(
            {preview.triangles[i], preview.triangles[i + 1], preview.triangles[i + 2]});
    }
    mesh.corner_colours = corner_colours(preview);
    return mesh;
}

}  // namespace ossuary::index
