#include "engine/mesh/recognise_format.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "engine/mesh/off_header.h"
#include "engine/mesh/ply_header.h"
#include "engine/mesh/read_obj.h"
#include "engine/mesh/read_stl.h"
#include "engine/mesh/read_xyz.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {
namespace {

/// The other objects of Geomview, of which OFF is one, by the first word of their files.
bool is_geomview(std::string_view bytes) {
    constexpr std::array<std::string_view, 10> kWords = {
        "LIST", "INST", "VECT", "SKEL", "MESH", "QUAD", "BEZ", "TLIST", "SPHERE", "appearance"};
    TextScanner scanner(bytes);
    if (!scanner.find_token()) return false;
    std::string_view token = scanner.peek_token();
    if (token.starts_with('{')) {  // an object within braces
        scanner.advance(1);
        if (!scanner.find_token()) return false;
        token = scanner.peek_token();
        if (token == "=") return true;
    }
    return std::find(kWords.begin(), kWords.end(), token) != kWords.end();
}

/// By the first tag, behind declarations and comments.
ModelFormat xml_format(std::string_view text) {
    for (std::size_t at = 0; at < text.size() && text[at] == '<';) {
        const std::string_view tag = text.substr(at);
        if (tag.starts_with("<COLLADA")) return ModelFormat::kCollada;
        if (tag.starts_with("<X3D")) return ModelFormat::kX3d;
        if (tag.starts_with("<amf") || tag.starts_with("<AMF")) return ModelFormat::kAmf;
        if (!tag.starts_with("<?") && !tag.starts_with("<!")) break;
        const std::string_view end = tag.starts_with("<!--") ? "-->" : ">";
        const std::size_t after = tag.find(end);
        if (after == std::string_view::npos) break;
        at = text.find_first_not_of(" \t\r\n", at + after + end.size());
    }
    return text.starts_with("<?xml") ? ModelFormat::kXml : ModelFormat::kUnknown;
}

/// The first word may stand behind blanks and comments.
bool is_step(std::string_view text) {
    while (true) {
        const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
        if (first == std::string_view::npos) return false;
        text.remove_prefix(first);
        if (!text.starts_with("/*")) return text.starts_with("ISO-10303-21");
        const std::size_t end = text.find("*/", 2);
        if (end == std::string_view::npos) return false;
        text.remove_prefix(end + 2);
    }
}

/// Lines of 80 characters, of which the last eight are the section and the line's number in it.
bool is_iges(std::string_view text) {
    constexpr std::size_t kSection = 72;
    constexpr std::size_t kLine = 80;
    if (text.size() <= kLine || text[kSection] != 'S') return false;
    const std::string_view number = text.substr(kSection + 1, kLine - kSection - 1);
    const std::size_t first = number.find_first_not_of(" 0");
    return first == number.size() - 1 && number.back() == '1' &&
           text.substr(0, kSection).find_first_of("\r\n") == std::string_view::npos &&
           (text[kLine] == '\n' || text[kLine] == '\r');
}

/// Whether a ZIP archive is a 3MF package, by the names in its directory at the end.
bool is_three_mf(std::string_view archive) {
    constexpr std::size_t kDirectory = 1 << 20;
    const std::string_view end =
        archive.substr(archive.size() - std::min(archive.size(), kDirectory));
    return end.find("[Content_Types].xml") != std::string_view::npos &&
           end.find(".model") != std::string_view::npos;
}

}  // namespace

ModelFormat recognise_format(std::string_view bytes) {
    constexpr std::size_t kGlance = 4096;
    const std::string_view start = bytes.substr(0, kGlance);
    if (is_binary_stl(bytes)) return ModelFormat::kStlBinary;
    if (bytes.starts_with("glTF")) return ModelFormat::kGltfBinary;
    if (bytes.starts_with("#VRML")) return ModelFormat::kVrml;
    if (bytes.starts_with("PK\x03\x04")) {
        return is_three_mf(bytes) ? ModelFormat::kThreeMf : ModelFormat::kZip;
    }
    if (bytes.starts_with("Kaydara FBX")) return ModelFormat::kFbx;
    if (is_step(start)) return ModelFormat::kStep;
    if (is_iges(start)) return ModelFormat::kIges;
    if (looks_like_ply(bytes)) return ModelFormat::kPly;
    if (looks_like_off(bytes)) {
        return is_xyz_rather_than_off(bytes) ? ModelFormat::kXyz : ModelFormat::kOff;
    }
    if (resembles_binary_stl(bytes)) return ModelFormat::kStlBinary;
    if (looks_like_stl_text(bytes)) return ModelFormat::kStlText;

    const std::size_t first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const std::string_view text = first == std::string_view::npos ? "" : start.substr(first);
    // The asset may stand at the end.
    if (text.starts_with("{") && bytes.find("\"asset\"") != std::string_view::npos) {
        return ModelFormat::kGltfText;
    }
    if (text.starts_with("; FBX")) return ModelFormat::kFbx;
    if (text.starts_with('<')) return xml_format(text);
    if (is_geomview(bytes)) return ModelFormat::kGeomview;
    if (looks_like_obj(bytes)) return ModelFormat::kObj;
    return looks_like_xyz(bytes) ? ModelFormat::kXyz : ModelFormat::kUnknown;
}

std::string_view to_string(ModelFormat format) {
    switch (format) {
        case ModelFormat::kUnknown:
            return "unknown";
        case ModelFormat::kOff:
            return "OFF";
        case ModelFormat::kStlText:
            return "STL (text)";
        case ModelFormat::kStlBinary:
            return "STL (binary)";
        case ModelFormat::kPly:
            return "PLY";
        case ModelFormat::kObj:
            return "OBJ";
        case ModelFormat::kXyz:
            return "XYZ (points as text)";
        case ModelFormat::kGltfText:
            return "glTF";
        case ModelFormat::kGltfBinary:
            return "glTF (binary)";
        case ModelFormat::kVrml:
            return "VRML";
        case ModelFormat::kThreeMf:
            return "3MF";
        case ModelFormat::kZip:
            return "ZIP";
        case ModelFormat::kXml:
            return "XML (not COLLADA, X3D or AMF)";
        case ModelFormat::kCollada:
            return "COLLADA";
        case ModelFormat::kX3d:
            return "X3D";
        case ModelFormat::kAmf:
            return "AMF";
        case ModelFormat::kFbx:
            return "FBX";
        case ModelFormat::kStep:
            return "STEP";
        case ModelFormat::kIges:
            return "IGES";
        case ModelFormat::kGeomview:
            return "Geomview (not OFF)";
    }
    assert(false);
    return "unknown";
}

}  // namespace ossuary::mesh
