#include "index/reader/protocol.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "index/bytes.h"

namespace ossuary::index {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "positions travel as they lie in memory");
static_assert(sizeof(mesh::TriangleMesh::Triangle) == 3 * sizeof(std::uint32_t));
static_assert(sizeof(mesh::CornerColours) == 9);

constexpr std::size_t kLongestText = 4000;
constexpr std::size_t kMaxNotes = 64 << 20;  ///< bytes of names and warnings

/// What the answer's file holds: notes, positions, triangles, the face of each triangle where that
/// is not its own number, and the colours where there are any.
struct AnswerSizes {
    std::uint64_t notes = 0;
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    std::uint32_t faces = 0;
    bool with_faces = false;
    bool with_colours = false;
};

std::string encode_sizes(const AnswerSizes& sizes) {
    ByteWriter writer;
    writer.put(static_cast<std::uint8_t>(MessageKind::kMesh));
    writer.put(sizes.notes);
    writer.put(sizes.vertices);
    writer.put(sizes.triangles);
    writer.put(sizes.faces);
    writer.put(static_cast<std::uint8_t>(sizes.with_faces));
    writer.put(static_cast<std::uint8_t>(sizes.with_colours));
    return std::move(writer).take();
}

std::string encode_notes(const mesh::ReadMeshResult& read) {
    ByteWriter writer;
    writer.put(read.metres_per_unit);
    writer.put(static_cast<std::uint8_t>(read.up ? 1 + static_cast<int>(*read.up) : 0));
    writer.put(static_cast<std::uint32_t>(read.warnings.size()));
    for (const mesh::MeshWarning& warning : read.warnings) {
        writer.put_text(warning.code);
        writer.put(static_cast<std::uint64_t>(warning.count));
        writer.put_text(std::string_view(warning.message).substr(0, kLongestText));
    }
    writer.put(static_cast<std::uint32_t>(read.objects.size()));
    for (const mesh::ModelObject& object : read.objects) {
        writer.put_text(std::string_view(object.name).substr(0, kLongestText));
        writer.put(object.first_triangle);
        writer.put(object.triangles);
    }
    return std::move(writer).take();
}

/// Whether a run lies within so many.
bool lies_within(std::uint32_t first, std::uint32_t count, std::size_t all) {
    return std::uint64_t{first} + count <= all;
}

bool decode_notes(std::string_view notes, mesh::ReadMeshResult& read) {
    ByteReader reader(notes);
    read.metres_per_unit = reader.get<double>();
    const auto up = reader.get<std::uint8_t>();
    if (up > 3 || !std::isfinite(read.metres_per_unit) || read.metres_per_unit < 0.0) return false;
    if (up > 0) read.up = static_cast<mesh::UpAxis>(up - 1);
    const std::uint32_t warnings = reader.get_count(16);
    for (std::uint32_t i = 0; i < warnings; ++i) {
        mesh::MeshWarning warning;
        warning.code = reader.get_text();
        warning.count = reader.get<std::uint64_t>();
        warning.message = reader.get_text();
        read.warnings.push_back(std::move(warning));
    }
    const std::uint32_t objects = reader.get_count(12);
    for (std::uint32_t i = 0; i < objects; ++i) {
        mesh::ModelObject object;
        object.name = reader.get_text();
        object.first_triangle = reader.get<std::uint32_t>();
        object.triangles = reader.get<std::uint32_t>();
        if (!lies_within(object.first_triangle, object.triangles, read.mesh.triangles.size())) {
            return false;
        }
        read.objects.push_back(std::move(object));
    }
    return reader.ok() && reader.at_end();
}

bool is_whole(const mesh::TriangleMesh& mesh, double max_coordinate) {
    const bool in_range =
        std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& position) {
            return (position.cwiseAbs().array() <= max_coordinate).all();  // false for NaN
        });
    const std::size_t vertices = mesh.vertices.size();
    return in_range &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                       [&](const mesh::TriangleMesh::Triangle& t) {
                           return t[0] < vertices && t[1] < vertices && t[2] < vertices;
                       }) &&
           std::all_of(mesh.face_of_triangle.begin(), mesh.face_of_triangle.end(),
                       [&](std::uint32_t face) { return face < mesh.face_count; });
}

/// Reads what follows in the file; `offset` goes along.
template <typename T>
bool take(int file, std::uint64_t& offset, std::vector<T>& values) {
    const std::size_t size = values.size() * sizeof(T);
    const std::uint64_t from = std::exchange(offset, offset + size);
    return read_exactly(file, values.data(), size, from);
}

bool names_faces(const mesh::TriangleMesh& mesh) {
    if (mesh.face_count != mesh.triangles.size()) return true;
    for (std::uint32_t t = 0; t < mesh.face_of_triangle.size(); ++t) {
        if (mesh.face_of_triangle[t] != t) return true;
    }
    return false;
}

Error no_answer() {
    return {ErrorCode::kReaderCrashed, "expected an answer from the reader, found something else"};
}

/// Puts bytes into the answer's file, and how many into the message.
Result<std::string> write_bytes(MessageKind kind, std::string_view bytes, int file) {
    if (!write_all(file, bytes.data(), bytes.size())) {
        return {ErrorCode::kReaderMemory,
                "expected fewer bytes, found " + std::to_string(bytes.size()) + " unpacked"};
    }
    ByteWriter writer;
    writer.put(static_cast<std::uint8_t>(kind));
    writer.put(static_cast<std::uint64_t>(bytes.size()));
    return std::move(writer).take();
}

Result<WholeFile> read_bytes(MessageKind kind, std::string_view message, int file,
                             std::uint64_t max_bytes) {
    ByteReader reader(text_of(message));
    const auto size = reader.get<std::uint64_t>();
    if (kind_of(message) != kind || !reader.ok() || !reader.at_end() || size > max_bytes) {
        return no_answer();
    }
    WholeFile bytes(size);
    if (!read_exactly(file, bytes.data(), bytes.size(), 0)) return no_answer();
    return bytes;
}

}  // namespace

MessageKind kind_of(std::string_view message) {
    return message.empty() ? MessageKind::kFault : static_cast<MessageKind>(message.front());
}

std::string text_message(MessageKind kind, std::string_view text) {
    std::string message(1, static_cast<char>(kind));
    message += text.substr(0, kLongestText);
    return message;
}

std::string_view text_of(std::string_view message) {
    return message.empty() ? message : message.substr(1);
}

std::string encode_request(const ReadRequest& request) {
    ByteWriter writer;
    writer.put(static_cast<std::uint8_t>(MessageKind::kRead));
    writer.put(static_cast<std::uint8_t>(request.format));
    writer.put(request.caps.max_bytes);
    writer.put(request.caps.max_vertices);
    writer.put(request.caps.max_faces);
    writer.put(request.caps.max_face_corners);
    writer.put(request.caps.max_triangles);
    writer.put(request.caps.max_coordinate);
    return std::move(writer).take();
}

Result<ReadRequest> decode_request(std::string_view message) {
    ByteReader reader(text_of(message));
    ReadRequest request;
    request.format = static_cast<mesh::ModelFormat>(reader.get<std::uint8_t>());
    request.caps.max_bytes = reader.get<std::uint64_t>();
    request.caps.max_vertices = reader.get<std::uint32_t>();
    request.caps.max_faces = reader.get<std::uint32_t>();
    request.caps.max_face_corners = reader.get<std::uint32_t>();
    request.caps.max_triangles = reader.get<std::uint32_t>();
    request.caps.max_coordinate = reader.get<double>();
    if (kind_of(message) != MessageKind::kRead || !reader.ok() || !reader.at_end()) {
        return {ErrorCode::kInternal, "expected a request to read a model"};
    }
    return request;
}

std::string encode_unpack(const UnpackRequest& request) {
    ByteWriter writer;
    writer.put(static_cast<std::uint8_t>(MessageKind::kUnpack));
    writer.put(request.max_bytes);
    writer.put_text(request.member);
    return std::move(writer).take();
}

Result<UnpackRequest> decode_unpack(std::string_view message) {
    ByteReader reader(text_of(message));
    UnpackRequest request;
    request.max_bytes = reader.get<std::uint64_t>();
    request.member = reader.get_text();
    if (kind_of(message) != MessageKind::kUnpack || !reader.ok() || !reader.at_end()) {
        return {ErrorCode::kInternal, "expected a request to unpack a member"};
    }
    return request;
}

Result<std::string> write_members(const std::vector<ArchiveMember>& members, int file) {
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(members.size()));
    for (const ArchiveMember& member : members) {
        writer.put(member.size);
        writer.put_text(member.name);
    }
    return write_bytes(MessageKind::kMembers, writer.bytes(), file);
}

Result<std::string> write_unpacked(std::string_view bytes, int file) {
    return write_bytes(MessageKind::kUnpacked, bytes, file);
}

Result<std::vector<ArchiveMember>> read_members(std::string_view message, int file) {
    constexpr std::uint64_t kMostBytes = 256 << 20;
    const auto bytes = read_bytes(MessageKind::kMembers, message, file, kMostBytes);
    if (!bytes) return bytes.error();
    ByteReader reader(bytes->view());
    std::vector<ArchiveMember> members(reader.get_count(12));
    for (ArchiveMember& member : members) {
        member.size = reader.get<std::uint64_t>();
        member.name = reader.get_text();
        if (member.name.empty() || member.name.size() > kLongestMember) return no_answer();
    }
    if (!reader.ok() || !reader.at_end()) return no_answer();
    return members;
}

Result<WholeFile> read_unpacked(std::string_view message, int file, std::uint64_t max_bytes) {
    return read_bytes(MessageKind::kUnpacked, message, file, max_bytes);
}

std::string encode_fault(const Error& error) {
    return text_message(MessageKind::kFault,
                        std::string(to_string(error.code)) + " " + error.message);
}

Error decode_fault(std::string_view message) {
    const std::string_view text = text_of(message);
    const std::size_t space = text.find(' ');
    for (const ErrorCodeName& row : kErrorCodeNames) {
        if (space != std::string_view::npos && row.name == text.substr(0, space)) {
            return {row.code, std::string(text.substr(space + 1))};
        }
    }
    return no_answer();
}

Result<std::string> write_answer(const mesh::ReadMeshResult& read, int file) {
    const mesh::TriangleMesh& mesh = read.mesh;
    const std::string notes = encode_notes(read);
    const AnswerSizes sizes = {notes.size(),
                               static_cast<std::uint32_t>(mesh.vertices.size()),
                               static_cast<std::uint32_t>(mesh.triangles.size()),
                               mesh.face_count,
                               names_faces(mesh),
                               !mesh.corner_colours.empty()};
    const auto put = [&](const auto& values) {
        return write_all(file, values.data(), values.size() * sizeof(values[0]));
    };
    if (!put(notes) || !put(mesh.vertices) || !put(mesh.triangles) ||
        (sizes.with_faces && !put(mesh.face_of_triangle)) ||
        (sizes.with_colours && !put(mesh.corner_colours))) {
        return {ErrorCode::kReaderMemory, "expected a smaller mesh, found one of " +
                                              std::to_string(mesh.triangles.size()) + " triangles"};
    }
    return encode_sizes(sizes);
}

Result<mesh::ReadMeshResult> read_answer(std::string_view message, int file,
                                         const mesh::ReadMeshOptions& caps) {
    ByteReader reader(text_of(message));
    AnswerSizes sizes;
    sizes.notes = reader.get<std::uint64_t>();
    sizes.vertices = reader.get<std::uint32_t>();
    sizes.triangles = reader.get<std::uint32_t>();
    sizes.faces = reader.get<std::uint32_t>();
    sizes.with_faces = reader.get<std::uint8_t>() != 0;
    sizes.with_colours = reader.get<std::uint8_t>() != 0;
    if (kind_of(message) != MessageKind::kMesh || !reader.ok() || sizes.notes > kMaxNotes ||
        sizes.vertices > caps.max_vertices || sizes.triangles > caps.max_triangles ||
        sizes.faces > caps.max_faces || (!sizes.with_faces && sizes.faces != sizes.triangles)) {
        return no_answer();
    }
    mesh::ReadMeshResult read;
    std::vector<char> notes(sizes.notes);
    read.mesh.vertices.resize(sizes.vertices);
    read.mesh.triangles.resize(sizes.triangles);
    read.mesh.face_of_triangle.resize(sizes.triangles);
    read.mesh.face_count = sizes.faces;
    std::uint64_t offset = 0;
    bool whole = take(file, offset, notes) && take(file, offset, read.mesh.vertices) &&
                 take(file, offset, read.mesh.triangles);
    if (sizes.with_faces) {
        whole = whole && take(file, offset, read.mesh.face_of_triangle);
    } else {
        std::iota(read.mesh.face_of_triangle.begin(), read.mesh.face_of_triangle.end(), 0u);
    }
    if (sizes.with_colours) {
        read.mesh.corner_colours.resize(sizes.triangles);
        whole = whole && take(file, offset, read.mesh.corner_colours);
    }
    if (!whole || !is_whole(read.mesh, caps.max_coordinate) ||
        !decode_notes({notes.data(), notes.size()}, read)) {
        return no_answer();
    }
    return read;
}

}  // namespace ossuary::index
