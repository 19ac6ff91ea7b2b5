#include "engine/mesh/read_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>

#include "engine/core/whole_file.h"
#include "engine/mesh/inspect.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_obj.h"
#include "engine/mesh/read_off.h"
#include "engine/mesh/read_ply.h"
#include "engine/mesh/read_stl.h"
#include "engine/mesh/read_xyz.h"
#include "engine/mesh/recognise_format.h"
#include "engine/mesh/text_scanner.h"

namespace ossuary::mesh {
namespace {

Error too_large(std::string_view name, std::uint64_t size, std::uint64_t cap) {
    return {ErrorCode::kFileTooLarge, std::string(name) + ": expected at most " +
                                          std::to_string(cap) + " bytes, found " +
                                          std::to_string(size)};
}

Result<void> check_extent(const TriangleMesh& mesh, std::string_view name,
                          const ReadMeshOptions& options) {
    if (mesh.empty()) return {};
    const double extent = measure(mesh).bounds.sizes().maxCoeff();
    if (extent == 0.0 || extent >= options.min_extent) return {};
    std::ostringstream text;
    text << name << ": expected an extent of at least " << options.min_extent << ", found "
         << extent;
    return {ErrorCode::kMeshScale, text.str()};
}

using FormatReader = Result<ReadMeshResult> (*)(std::string_view, std::string_view,
                                                const ReadMeshOptions&, const std::stop_token&);

/// What reads a format, null where nothing does.
FormatReader reader_of(ModelFormat format) {
    switch (format) {
        case ModelFormat::kOff:
            return read_off;
        case ModelFormat::kStlText:
        case ModelFormat::kStlBinary:
            return read_stl;
        case ModelFormat::kObj:
            return read_obj;
        case ModelFormat::kPly:
            return read_ply;
        case ModelFormat::kXyz:
            return read_xyz;
        default:
            return nullptr;
    }
}

Error not_read(std::string_view bytes, std::string_view name) {
    const std::string expected =
        std::string(name) + ": expected an OFF, STL, OBJ, PLY or XYZ file, found ";
    const ModelFormat format = recognise_format(bytes);
    if (format != ModelFormat::kUnknown) {
        return {ErrorCode::kFormatUnsupported, expected + std::string(to_string(format))};
    }
    return {
        ErrorCode::kFormatUnknown,
        expected + (bytes.empty() ? "an empty file"
                                  : "one that begins with " + quoted_token(bytes.substr(0, 16)))};
}

}  // namespace

Result<ReadMeshResult> read_mesh(const std::filesystem::path& path, const ReadMeshOptions& options,
                                 const std::stop_token& stop) {
    const Result<WholeFile> file = read_whole_file(path, options.max_bytes);
    if (!file) return file.error();
    return read_mesh(file->view(), path.string(), options, stop);
}

Result<ReadMeshResult> read_mesh(std::string_view bytes, std::string_view name,
                                 const ReadMeshOptions& options, const std::stop_token& stop) {
    if (bytes.size() > options.max_bytes) return too_large(name, bytes.size(), options.max_bytes);
    const FormatReader reader = reader_of(recognise_format(bytes));
    if (reader == nullptr) return not_read(bytes, name);
    Result<ReadMeshResult> result = reader(bytes, name, options, stop);
    if (!result) return result;
    return finish_reading(*std::move(result), name, options, stop);
}

Result<ReadMeshResult> finish_reading(ReadMeshResult read, std::string_view name,
                                      const ReadMeshOptions& options, const std::stop_token& stop) {
    if (Result<void> checked = check_extent(read.mesh, name, options); !checked) {
        return checked.error();
    }
    if (stop.stop_requested()) {
        return {ErrorCode::kCancelled, std::string(name) + ": reading was cancelled"};
    }
    for (MeshWarning& warning : surface_warnings(read.mesh)) {
        read.warnings.push_back(std::move(warning));
    }
    return read;
}

bool is_model_file(const std::filesystem::path& path) {
    constexpr std::array<std::string_view, 28> kExtensions = {
        ".off", ".coff",   ".noff", ".cnoff", ".ncoff", ".stoff", ".stl",  ".obj", ".ply", ".xyz",
        ".pts", ".asc",    ".3mf",  ".gltf",  ".glb",   ".dae",   ".x3d",  ".amf", ".fbx", ".nrrd",
        ".nii", ".binvox", ".npy",  ".zip",   ".step",  ".stp",   ".iges", ".igs"};
    const auto lower_extension = [](const std::filesystem::path& name) {
        std::string extension = name.extension().string();
        for (char& c : extension) {
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        return extension;
    };
    std::string extension = lower_extension(path);
    if (extension == ".gz") extension = lower_extension(path.stem());
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace ossuary::mesh
