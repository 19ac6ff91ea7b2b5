#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/text_scanner.h"
#include "engine/mesh/triangulate.h"

namespace ossuary::mesh {

/// The codes under which the reader of one format refuses what any format can be wrong about.
struct ReaderCodes {
    ErrorCode too_many_vertices;
    ErrorCode too_many_faces;
    ErrorCode too_many_corners;
    ErrorCode bad_number;
    ErrorCode non_finite;
};

/// What the readers of all formats do alike: they hold numbers against the caps, cut polygons into
/// triangles and count what is odd. Messages do not say where in the file; readers put that before.
class MeshBuilder {
public:
    /// `options` must outlive the builder.
    MeshBuilder(const ReaderCodes& codes, const ReadMeshOptions& options, std::stop_token stop)
        : codes_(codes), options_(options), stop_(std::move(stop)) {}

    [[nodiscard]] const std::vector<Vec3>& vertices() const { return mesh_.vertices; }
    [[nodiscard]] std::uint32_t face_count() const { return mesh_.face_count; }
    [[nodiscard]] std::uint32_t triangle_count() const {
        return static_cast<std::uint32_t>(mesh_.triangles.size());
    }
    [[nodiscard]] bool cancelled() const { return stop_.stop_requested(); }

    void reserve(std::size_t vertices, std::size_t faces);
    void add_vertex(const Vec3& position) { mesh_.vertices.push_back(position); }
    /// For readers that number vertices themselves.
    void set_vertices(std::vector<Vec3> vertices) { mesh_.vertices = std::move(vertices); }

    /// Errors: too_many_vertices, too_many_faces.
    [[nodiscard]] Result<void> check_counts(std::uint64_t vertices, std::uint64_t faces) const;
    /// Errors: too_many_corners, for the next face.
    [[nodiscard]] Result<void> check_corners(std::uint64_t corners) const {
        if (corners <= options_.max_face_corners) return {};
        return too_many_corners(std::to_string(corners));
    }
    [[nodiscard]] Error too_many_corners(const std::string& found) const;

    /// Reads the coordinate of a vertex at the scanner's position, which stays there on failure.
    /// Errors: bad_number, non_finite, mesh_scale.
    [[nodiscard]] Result<void> read_coordinate(TextScanner& scanner, std::uint64_t vertex, int axis,
                                               double& value) const {
        TextScanner ahead = scanner;
        const NumberStatus status = ahead.read_double(value);
        if (status != NumberStatus::kOk || !is_in_range(value)) {
            return coordinate_error(vertex, axis, status, quoted_token(scanner.peek_token()));
        }
        scanner = ahead;
        return {};
    }
    /// Whether a number is one that coordinates may be; false for those that are not finite.
    [[nodiscard]] bool is_in_range(double value) const {
        return std::abs(value) <= options_.max_coordinate;
    }
    [[nodiscard]] bool is_in_range(const Vec3& position) const {
        return (position.cwiseAbs().array() <= options_.max_coordinate).all();
    }
    /// What is wrong with a position that is not in range.
    [[nodiscard]] Error position_error(std::uint64_t vertex, const Vec3& position) const;

    /// Adds a polygon; with fewer than three corners it gives no triangle. Errors: too_many_faces
    /// (also for triangles in all), cancelled.
    /// @pre  each corner is the index of a vertex that was added
    [[nodiscard]] Result<void> add_face(std::span<const std::uint32_t> corners) {
        if ((mesh_.face_count & kFacesBetweenLooks) == 0 && cancelled()) return cancellation();
        if (corners.size() != 3 || mesh_.triangles.size() >= options_.max_triangles) {
            return add_polygon(corners);
        }
        mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
        mesh_.face_of_triangle.push_back(mesh_.face_count++);
        return {};
    }

    /// Colours the face that was added last: all of it, or each of its corners. Faces that are left
    /// out are plain where others have a colour.
    void colour_face(const Colour& colour);
    void colour_face(std::span<const std::uint32_t> corners, std::span<const Colour> colours);
    /// Colours all corners by their vertices, or all faces by their numbers; none where there are
    /// none.
    void set_vertex_colours(std::vector<Colour> colours) { vertex_colours_ = std::move(colours); }
    void set_face_colours(std::vector<Colour> colours) { face_colours_ = std::move(colours); }

    [[nodiscard]] static Error cancellation() {
        return {ErrorCode::kCancelled, "reading was cancelled"};
    }

    void warn(const char* code, std::size_t count, std::string message) {
        if (count > 0) warnings_.push_back({code, count, std::move(message)});
    }
    /// The mesh with its colours and the warnings; adds faces_under_three_corners and
    /// polygons_without_ears.
    [[nodiscard]] ReadMeshResult take();

private:
    static constexpr std::uint32_t kFacesBetweenLooks = 0xFFF;

    [[nodiscard]] Error coordinate_error(std::uint64_t vertex, int axis, NumberStatus status,
                                         const std::string& found) const;
    [[nodiscard]] Result<void> add_polygon(std::span<const std::uint32_t> corners);
    [[nodiscard]] std::size_t first_triangle_of_last_face() const;
    void colour_triangles();

    ReaderCodes codes_;
    const ReadMeshOptions& options_;
    std::stop_token stop_;
    TriangleMesh mesh_;
    PolygonTriangulator triangulator_;
    std::vector<MeshWarning> warnings_;
    std::size_t small_faces_ = 0;
    std::vector<Colour> vertex_colours_;
    std::vector<Colour> face_colours_;
    std::vector<Colour> colour_of_corner_;  ///< by vertex, of the face that was coloured last
};

/// "1 face", "2 faces".
[[nodiscard]] std::string plural(std::uint64_t count, const std::string& noun);

/// With as many digits as tell it from every other number.
[[nodiscard]] std::string number_text(double value);

/// An error with the given code where text holds a NUL byte.
[[nodiscard]] std::optional<Error> nul_byte(std::string_view text, ErrorCode code);

/// "line 7: " before the message.
[[nodiscard]] Error at_line(std::size_t line, const Error& error);

}  // namespace ossuary::mesh
