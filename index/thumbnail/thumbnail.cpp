#include "index/thumbnail/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "engine/mesh/cluster_vertices.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/weld.h"
#include "index/thumbnail/outline_mask.h"
#include "index/thumbnail/png_bytes.h"
#include "index/thumbnail/sample_hits.h"
#include "index/thumbnail/smooth_shading.h"

namespace ossuary::index {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Vec3f linear_color(const Rgb& srgb) {
    return {mesh::linear_from_srgb(srgb[0]), mesh::linear_from_srgb(srgb[1]),
            mesh::linear_from_srgb(srgb[2])};
}

Result<void> check(const mesh::TriangleMesh& mesh, const ThumbnailOptions& options) {
    const auto invalid = [](const char* text) -> Result<void> {
        return {ErrorCode::kInvalidArgument, text};
    };
    if (options.size < 16 || options.size > 2048) {
        return invalid("thumbnail size: expected 16 to 2048 pixels");
    }
    if (options.samples_per_side < 1 || options.samples_per_side > 8) {
        return invalid("thumbnail samples: expected 1 to 8 along a pixel's side");
    }
    if (!(options.margin >= 0 && options.margin < 0.5)) {
        return invalid("thumbnail margin: expected 0 to 0.5 of the picture");
    }
    if (!options.triangle_colors.empty() &&
        options.triangle_colors.size() != mesh.triangles.size()) {
        return invalid("thumbnail colors: expected one for each triangle");
    }
    if (!(options.up.cross(options.towards_viewer).norm() > 1e-9)) {
        return invalid("thumbnail view: expected an upward direction across the line of sight");
    }
    if (mesh.empty()) return {ErrorCode::kMeshEmpty, "a mesh without triangles has no picture"};
    if (!(mesh::measure(mesh).surface_area > 0)) {
        return {ErrorCode::kMeshNoExtent, "a mesh without area has no picture"};
    }
    return {};
}

Error cancelled() { return {ErrorCode::kCancelled, "drawing was cancelled"}; }

/// The vertices as they fall into the picture: in pixels, x to the right and y downwards from the
/// upper left corner, z towards the viewer.
std::vector<Vec3f> framed_vertices(const mesh::TriangleMesh& mesh,
                                   const ThumbnailOptions& options) {
    const Vec3 towards = options.towards_viewer.normalized();
    const Vec3 right = options.up.cross(towards).normalized();
    Mat3 view;
    view.row(0) = right;
    view.row(1) = right.cross(towards);  // downwards
    view.row(2) = towards;
    const Vec3 origin = mesh.vertices[0];  // so that a place far away costs no digits
    std::vector<Vec3> seen(mesh.vertices.size());
    Box3 bounds;
    for (std::size_t v = 0; v < seen.size(); ++v) {
        seen[v] = view * (mesh.vertices[v] - origin);
        bounds.extend(seen[v]);
    }
    // A line of sight along a flat model leaves it one-dimensional: its depth then sets the scale.
    const double widest = std::max(bounds.sizes().x(), bounds.sizes().y());
    const double scale =
        options.size * (1 - 2 * options.margin) / (widest > 0 ? widest : bounds.sizes().z());
    const Vec3 middle(options.size / 2.0, options.size / 2.0, 0.0);
    std::vector<Vec3f> vertices(seen.size());
    for (std::size_t v = 0; v < seen.size(); ++v) {
        vertices[v] = (scale * (seen[v] - bounds.center()) + middle).cast<float>();
    }
    return vertices;
}

struct Pixel {
    Vec3f light = Vec3f::Zero();  // linear, of the part that the surface covers
    float covered = 0.0f;
};

/// Looks at each pixel's middle first, then at more points of those where that is not enough: half
/// the time of nine points of every pixel, with sixteen where they count. What is seen there is
/// found triangle by triangle: rays through a tree of the triangles (Embree) took pictures 35 ms of
/// processor time instead of 25 (every eighth of 380 models).
class Painter {
public:
    Painter(const mesh::WeldResult& welded, const std::vector<Vec3f>& vertices,
            const ThumbnailOptions& options)
        : mesh_(welded.mesh),
          vertices_(vertices),
          options_(options),
          normals_(vertices, welded.mesh.triangles),
          color_(linear_color(options.color)),
          pixels_(static_cast<std::size_t>(options.size * options.size)),
          normal_of_(pixels_.size(), Vec3f::Zero()),
          color_of_(pixels_.size(), Vec3f::Zero()) {
        if (!options.triangle_colors.empty()) {
            for (const std::uint32_t source : welded.source_triangle) {
                triangle_colors_.push_back(linear_color(options.triangle_colors[source]));
            }
        }
        for (std::size_t byte = 0; byte < light_of_.size(); ++byte) {
            light_of_[byte] = mesh::linear_from_srgb(static_cast<std::uint8_t>(byte));
        }
    }

    /// Once `stop` is requested, the picture is not finished.
    std::vector<Pixel> paint(const std::stop_token& stop) {
        paint_centers(stop);
        std::vector<std::uint8_t> refine = outline_mask(mesh_, vertices_, options_.size);
        mark_differences(refine);
        // Where most of the picture is edges, a thicket, few rays show it as well as many.
        const auto marked = std::count(refine.begin(), refine.end(), std::uint8_t{1});
        const bool thicket = 2 * static_cast<std::size_t>(marked) > pixels_.size();
        const int samples =
            thicket ? std::min(options_.samples_per_side, 2) : options_.samples_per_side;
        const auto hits =
            find_sample_hits(vertices_, mesh_.triangles, {options_.size, samples, refine}, stop);
        const auto each = static_cast<std::size_t>(samples) * std::size_t(samples);
        std::size_t next = 0;
        for (std::size_t p = 0; p < pixels_.size(); ++p) {
            if (refine[p] == 0) continue;
            if (stop.stop_requested()) break;
            refine_pixel(p, std::span(hits).subspan(next, each));
            next += each;
        }
        return std::move(pixels_);
    }

private:
    /// That of the triangle as asked for, else the mesh's own, else the one for all.
    [[nodiscard]] Vec3f color_at(const SampleHit& hit) const {
        if (!triangle_colors_.empty()) return triangle_colors_[hit.triangle];
        if (mesh_.corner_colours.empty()) return color_;
        const auto& [a, b, c] = mesh_.corner_colours[hit.triangle];
        return (1 - hit.u - hit.v) * light(a) + hit.u * light(b) + hit.v * light(c);
    }
    [[nodiscard]] Vec3f light(const Rgb& srgb) const {
        return {light_of_[srgb[0]], light_of_[srgb[1]], light_of_[srgb[2]]};
    }

    void paint_centers(const std::stop_token& stop) {
        const auto hits =
            find_sample_hits(vertices_, mesh_.triangles, {options_.size, 1, {}}, stop);
        for (std::size_t p = 0; p < hits.size() && !stop.stop_requested(); ++p) {
            const SampleHit& hit = hits[p];
            if (hit.triangle == SampleHit::kNone) continue;
            normal_of_[p] = normals_.at(hit);
            color_of_[p] = color_at(hit);
            pixels_[p] = {lit_color(normal_of_[p], color_of_[p]), 1.0f};
        }
    }

    /// Marks pixels that differ much from the one to their right or below; the normal is zero where
    /// there is no surface. This finds what outlines do not: pieces that pass through each other.
    void mark_differences(std::vector<std::uint8_t>& refine) const {
        const auto size = static_cast<std::size_t>(options_.size);
        const auto compare = [&](std::size_t p, std::size_t q) {
            constexpr float kMuch = 0.3f;
            constexpr float kAnotherColor = 1e-4f;  // more than colours that run evenly differ
            if ((normal_of_[p] - normal_of_[q]).squaredNorm() > kMuch ||
                (color_of_[p] - color_of_[q]).squaredNorm() > kAnotherColor) {
                refine[p] = refine[q] = 1;
            }
        };
        for (std::size_t row = 0; row < size; ++row) {
            for (std::size_t column = 0; column < size; ++column) {
                const std::size_t p = row * size + column;
                if (column + 1 < size) compare(p, p + 1);
                if (row + 1 < size) compare(p, p + size);
            }
        }
    }

    void refine_pixel(std::size_t p, std::span<const SampleHit> hits) {
        Vec3f light = Vec3f::Zero();
        int met = 0;
        for (const SampleHit& hit : hits) {
            if (hit.triangle == SampleHit::kNone) continue;
            light += lit_color(normals_.at(hit), color_at(hit));
            ++met;
        }
        pixels_[p] = {};
        if (met == 0) return;
        pixels_[p].light = light / static_cast<float>(met);
        pixels_[p].covered = static_cast<float>(met) / static_cast<float>(hits.size());
    }

    const mesh::TriangleMesh& mesh_;
    const std::vector<Vec3f>& vertices_;
    const ThumbnailOptions& options_;
    SmoothNormals normals_;
    Vec3f color_;
    std::vector<Vec3f> triangle_colors_;
    std::array<float, 256> light_of_{};  ///< of each byte of a colour
    std::vector<Pixel> pixels_;
    std::vector<Vec3f> normal_of_;
    std::vector<Vec3f> color_of_;
};

std::vector<std::uint8_t> to_bytes(const std::vector<Pixel>& pixels,
                                   const ThumbnailOptions& options) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(pixels.size() * (options.background ? 3 : 4));
    for (const Pixel& pixel : pixels) {
        if (pixel.covered == 0.0f && !options.background) {
            bytes.insert(bytes.end(), 4, 0);
            continue;
        }
        Vec3f light = pixel.light;
        if (options.background) {
            light = pixel.covered * light + (1 - pixel.covered) * linear_color(*options.background);
        }
        for (const float x : light) bytes.push_back(mesh::srgb_from_linear(x));
        if (!options.background) {
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * pixel.covered)));
        }
    }
    return bytes;
}

/// More triangles than a picture can show are clustered.
constexpr std::size_t kMostDrawn = 500'000;

/// The mesh, or its clusters, which `coarse` then holds.
const mesh::TriangleMesh& drawable(const mesh::TriangleMesh& mesh, const ThumbnailOptions& options,
                                   mesh::TriangleMesh& coarse) {
    if (mesh.triangles.size() <= kMostDrawn || !options.triangle_colors.empty()) return mesh;
    coarse = mesh::cluster_vertices(mesh, kMostDrawn);
    return coarse.empty() ? mesh : coarse;
}

/// How many triangles' boxes lie over a pixel on average: what is looked at there, nearly.
double layers(const mesh::TriangleMesh& mesh, std::span<const Vec3f> vertices, int size) {
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3f low = vertices[a].cwiseMin(vertices[b]).cwiseMin(vertices[c]);
        const Vec3f high = vertices[a].cwiseMax(vertices[b]).cwiseMax(vertices[c]);
        area += static_cast<double>(high.x() - low.x()) * static_cast<double>(high.y() - low.y());
    }
    return area / (static_cast<double>(size) * static_cast<double>(size));
}

/// Of more layers, a thicket of long triangles, a coarse copy is drawn: of half a million slivers
/// across a cube the picture takes two minutes, of its clusters a second. Models have some tens.
constexpr double kMostLayers = 1000.0;
constexpr std::size_t kThicketTriangles = 1000;

}  // namespace

Result<PixelPicture> render_pixels(const mesh::TriangleMesh& mesh, const ThumbnailOptions& options,
                                   const std::stop_token& stop) {
    if (Result<void> checked = check(mesh, options); !checked) return checked.error();
    mesh::TriangleMesh coarse;
    // So that shading runs across a soup's seams.
    mesh::WeldResult welded = mesh::weld(drawable(mesh, options, coarse));
    std::vector<Vec3f> vertices = framed_vertices(welded.mesh, options);
    if (options.triangle_colors.empty() &&
        layers(welded.mesh, vertices, options.size) > kMostLayers) {
        coarse = mesh::cluster_vertices(welded.mesh, kThicketTriangles);
        if (!coarse.empty()) {
            welded = mesh::weld(coarse);
            vertices = framed_vertices(welded.mesh, options);
        }
    }
    if (stop.stop_requested()) return cancelled();
    const std::vector<Pixel> pixels = Painter(welded, vertices, options).paint(stop);
    if (stop.stop_requested()) return cancelled();
    return PixelPicture{options.size, options.background ? 3 : 4, to_bytes(pixels, options)};
}

Result<std::vector<std::uint8_t>> render_thumbnail(const mesh::TriangleMesh& mesh,
                                                   const ThumbnailOptions& options,
                                                   const std::stop_token& stop) {
    const Result<PixelPicture> picture = render_pixels(mesh, options, stop);
    if (!picture) return picture.error();
    return png_bytes(picture->bytes, picture->size, picture->size, picture->channels);
}

}  // namespace ossuary::index
