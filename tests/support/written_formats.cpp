#include "tests/support/written_formats.h"

#include <zip.h>

#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/mesh/measures.h"
#include "index/bytes.h"

namespace ossuary::test {
namespace {

constexpr const char* kTypes =
    R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
    R"(<Default Extension="rels" )"
    R"(ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
    R"(<Default Extension="model" )"
    R"(ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)";
constexpr const char* kRelations =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
    R"(<Relationship Target="/3D/3dmodel.model" Id="r" )"
    R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";

std::string chunk(const char* kind, std::string bytes, char filler) {
    bytes.resize((bytes.size() + 3) / 4 * 4, filler);
    index::ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(bytes.size()));
    writer.put_raw({kind, 4});
    writer.put_raw(bytes);
    return std::move(writer).take();
}

}  // namespace

SeparateGltf to_separate_gltf(const mesh::TriangleMesh& mesh, const std::string& buffer_name) {
    index::ByteWriter numbers;
    for (const Vec3& vertex : mesh.vertices) {
        for (const double x : vertex) numbers.put(static_cast<float>(x));
    }
    const std::size_t positions = numbers.bytes().size();
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) numbers.put(corner);
    }
    const std::size_t all = numbers.bytes().size();
    std::ostringstream text;
    text << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         << R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         << R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)"
         << mesh.vertices.size()
         << R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)"
         << 3 * mesh.triangles.size() << R"(}],"bufferViews":[{"buffer":0,"byteLength":)"
         << positions << R"(},{"buffer":0,"byteOffset":)" << positions << R"(,"byteLength":)"
         << all - positions << R"(}],"buffers":[{)"
         << (buffer_name.empty() ? "" : "\"uri\":\"" + buffer_name + "\",") << R"("byteLength":)"
         << all << "}]}";
    return {text.str(), std::move(numbers).take()};
}

std::string to_plain_glb(const mesh::TriangleMesh& mesh) {
    const SeparateGltf parts = to_separate_gltf(mesh, "");
    const std::string body = chunk("JSON", parts.document, ' ') +
                             chunk(std::string_view("BIN\0", 4).data(), parts.buffer, '\0');
    index::ByteWriter glb;
    glb.put_raw("glTF");
    glb.put(std::uint32_t{2});
    glb.put(static_cast<std::uint32_t>(12 + body.size()));
    glb.put_raw(body);
    return std::move(glb).take();
}

std::string to_nrrd(const Vec3i& size, const std::function<int(const Vec3i&)>& value) {
    std::ostringstream text;
    text << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " << size.x() << ' ' << size.y() << ' '
         << size.z() << "\nencoding: raw\n\n";
    std::string bytes = text.str();
    for (int z = 0; z < size.z(); ++z) {
        for (int y = 0; y < size.y(); ++y) {
            for (int x = 0; x < size.x(); ++x) bytes += static_cast<char>(value({x, y, z}));
        }
    }
    return bytes;
}

std::string three_mf_part(const std::string& resources, const std::string& build) {
    return R"(<model unit="millimeter" )"
           R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)" +
           resources + "</resources><build>" + build + "</build></model>";
}

std::string three_mf_object(const mesh::TriangleMesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << R"(<object id="1" type="model"><mesh><vertices>)";
    for (const Vec3& vertex : mesh.vertices) {
        text << "<vertex x=\"" << vertex.x() << "\" y=\"" << vertex.y() << "\" z=\"" << vertex.z()
             << "\"/>";
    }
    text << "</vertices><triangles>";
    for (const auto& triangle : mesh.triangles) {
        text << "<triangle v1=\"" << triangle[0] << "\" v2=\"" << triangle[1] << "\" v3=\""
             << triangle[2] << "\"/>";
    }
    text << "</triangles></mesh></object>";
    return text.str();
}

std::filesystem::path write_zip(const std::filesystem::path& path,
                                const std::vector<std::pair<std::string, std::string>>& members) {
    int error = 0;
    zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (archive == nullptr) throw std::runtime_error("no archive at " + path.string());
    for (const auto& [name, bytes] : members) {
        zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
        zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    }
    if (zip_close(archive) != 0) throw std::runtime_error("no archive at " + path.string());
    return path;
}

std::filesystem::path write_three_mf(const std::filesystem::path& path, const std::string& part) {
    return write_zip(
        path,
        {{"[Content_Types].xml", kTypes}, {"_rels/.rels", kRelations}, {"3D/3dmodel.model", part}});
}

}  // namespace ossuary::test
