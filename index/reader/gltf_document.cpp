#include "index/reader/gltf_document.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "index/bytes.h"
#include "index/json_text.h"

namespace ossuary::index {
namespace {

Error invalid(const std::string& message) {
    return {ErrorCode::kGltfInvalid, "expected glTF 2, found " + message};
}

/// What tinygltf's callbacks share: the way to ask, and the first refusal.
struct Files {
    const AskForFile& ask;
    std::optional<Error> refused;
};

bool file_exists(const std::string&, void*) { return true; }
std::string same_path(const std::string& path, void*) { return path; }

bool read_file(std::vector<unsigned char>* bytes, std::string* error, const std::string& name,
               void* user) {
    Files& files = *static_cast<Files*>(user);
    const Result<OwnedDescriptor> given = files.ask(name);
    const Result<MappedFile> mapped =
        given ? MappedFile::open(given->get()) : Result<MappedFile>(given.error());
    if (!mapped) {
        if (!files.refused) files.refused = mapped.error();
        *error += mapped.error().message;
        return false;
    }
    bytes->assign(mapped->view().begin(), mapped->view().end());
    return true;
}

bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                  const unsigned char*, int, void*) {
    return true;
}

/// Buffers that stand in for compressed ones and have no bytes, which tinygltf would refuse.
void fill_stand_ins(nlohmann::json& document) {
    const auto buffers = document.find("buffers");
    if (buffers == document.end() || !buffers->is_array()) return;
    for (nlohmann::json& buffer : *buffers) {
        if (!buffer.is_object() || buffer.contains("uri")) continue;
        const auto extensions = buffer.find("extensions");
        if (extensions == buffer.end() || !extensions->is_object() ||
            !extensions->contains("EXT_meshopt_compression")) {
            continue;
        }
        buffer["uri"] = "data:application/octet-stream;base64,AA==";
        buffer["byteLength"] = 1;
    }
}

/// The corners of primitives that are compressed with Draco are in there; what stands for them has
/// no numbers, which tinygltf would refuse.
void drop_indices_beside_draco(nlohmann::json& document) {
    const auto meshes = document.find("meshes");
    if (meshes == document.end() || !meshes->is_array()) return;
    for (nlohmann::json& mesh : *meshes) {
        if (!mesh.is_object() || !mesh.contains("primitives")) continue;
        nlohmann::json& primitives = mesh["primitives"];
        if (!primitives.is_array()) continue;
        for (nlohmann::json& primitive : primitives) {
            if (!primitive.is_object()) continue;
            const auto extensions = primitive.find("extensions");
            if (extensions != primitive.end() && extensions->is_object() &&
                extensions->contains("KHR_draco_mesh_compression")) {
                primitive.erase("indices");
            }
        }
    }
}

/// Without what tinygltf would look for or stumble over; among it images, which may be files.
Result<std::string> simplified(std::string_view text) {
    nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
    if (!document.is_object()) return invalid("text that is no JSON object");
    for (const char* member : {"images", "textures", "materials", "samplers", "animations"}) {
        document.erase(member);
    }
    fill_stand_ins(document);
    drop_indices_beside_draco(document);
    return json_text(document);
}

/// The parts of a GLB: its text and what stands behind it.
struct Glb {
    std::string_view json, rest;
};

Result<Glb> split_glb(std::string_view bytes) {
    ByteReader header(bytes.substr(4));
    const auto version = header.get<std::uint32_t>();
    header.get<std::uint32_t>();
    const auto length = header.get<std::uint32_t>();
    const auto kind = header.get<std::uint32_t>();
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::size_t kStart = 20;
    if (header.ok() && version != 2) return invalid("version " + std::to_string(version));
    if (!header.ok() || kind != kJson || length > bytes.size() - kStart) {
        return invalid("a GLB that ends early");
    }
    return Glb{bytes.substr(kStart, length), bytes.substr(kStart + length)};
}

std::string join_glb(std::string json, std::string_view rest) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    ByteWriter writer;
    writer.put_raw("glTF");
    writer.put(std::uint32_t{2});
    writer.put(static_cast<std::uint32_t>(20 + json.size() + rest.size()));
    writer.put(static_cast<std::uint32_t>(json.size()));
    writer.put_raw("JSON");
    writer.put_raw(json);
    writer.put_raw(rest);
    return std::move(writer).take();
}

/// The document as tinygltf takes it; empty where it takes it as it is.
Result<std::string> prepared(std::string_view bytes, bool binary) {
    Glb glb{bytes, {}};
    if (binary) {
        auto split = split_glb(bytes);
        if (!split) return split.error();
        glb = *split;
    }
    const auto mentions = [&](std::string_view word) {
        return glb.json.find(word) != std::string_view::npos;
    };
    if (!mentions("\"images\"") && !mentions("EXT_meshopt_compression") &&
        !mentions("KHR_draco_mesh_compression")) {
        return std::string();
    }
    auto text = simplified(glb.json);
    if (!text) return text;
    return binary ? join_glb(*std::move(text), glb.rest) : text;
}

/// Extensions that say nothing of where triangles are, or that are read.
Result<void> check_extensions(const tinygltf::Model& model) {
    constexpr std::array<std::string_view, 8> kRead = {"KHR_draco_mesh_compression",
                                                       "EXT_meshopt_compression",
                                                       "KHR_mesh_quantization",
                                                       "KHR_lights_punctual",
                                                       "KHR_animation_pointer",
                                                       "KHR_xmp",
                                                       "KHR_xmp_json_ld",
                                                       "MSFT_lod"};
    constexpr std::array<std::string_view, 6> kLooks = {"KHR_materials_", "KHR_texture_",
                                                        "KHR_technique",  "EXT_texture_",
                                                        "MSFT_texture_",  "EXT_lights_"};
    for (const std::string& name : model.extensionsRequired) {
        const bool fine = std::find(kRead.begin(), kRead.end(), name) != kRead.end() ||
                          std::any_of(kLooks.begin(), kLooks.end(), [&](std::string_view start) {
                              return name.starts_with(start);
                          });
        if (!fine) {
            return {ErrorCode::kGltfExtension,
                    "expected extensions that can be read, found " + name + " required"};
        }
    }
    return {};
}

/// The first line of what tinygltf says.
std::string first_line(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.empty() ? "a document that cannot be used" : line;
}

}  // namespace

Result<tinygltf::Model> open_gltf(std::string_view bytes, const AskForFile& ask) {
    const bool binary = bytes.starts_with("glTF");
    auto patched = prepared(bytes, binary);
    if (!patched) return patched.error();
    const std::string_view document = patched->empty() ? bytes : std::string_view(*patched);
    if (document.size() > std::numeric_limits<std::uint32_t>::max()) {
        return {ErrorCode::kReaderMemory, "expected a document below 4 GB"};
    }
    const auto size = static_cast<unsigned int>(document.size());

    tinygltf::TinyGLTF loader;
    Files files{ask, {}};
    loader.SetFsCallbacks({file_exists, same_path, read_file, nullptr, &files});
    loader.SetImageLoader(ignore_image, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    const bool loaded =
        binary ? loader.LoadBinaryFromMemory(
                     &model, &error, &warning,
                     reinterpret_cast<const unsigned char*>(document.data()), size)
               : loader.LoadASCIIFromString(&model, &error, &warning, document.data(), size, "");
    if (files.refused) return *files.refused;
    if (!loaded) return invalid(first_line(error));
    if (!model.asset.version.starts_with("2")) return invalid("version " + model.asset.version);
    if (auto known = check_extensions(model); !known) return known.error();
    return model;
}

}  // namespace ossuary::index
