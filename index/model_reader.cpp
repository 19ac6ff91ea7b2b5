#include "index/model_reader.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "engine/mesh/model_objects.h"
#include "engine/mesh/recognise_format.h"
#include "engine/mesh/text_scanner.h"
#include "engine/voxel/read_model.h"
#include "index/companion_hash.h"
#include "index/material_libraries.h"
#include "index/model_files.h"
#include "index/model_place.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

/// What a package of another format has at its root (3MF among them, part 2 of ECMA-376).
constexpr std::string_view kPackageTypes = "[Content_Types].xml";

using Archive = std::shared_ptr<const OwnedDescriptor>;

Result<Archive> open_archive(const fs::path& path) {
    OwnedDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!file.is_open() || ::fstat(file.get(), &status) != 0) {
        const auto code = errno == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileUnreadable;
        return {code, std::generic_category().message(errno)};
    }
    if (!S_ISREG(status.st_mode)) {
        return {ErrorCode::kFileUnreadable, "expected a regular file, found something else"};
    }
    return std::make_shared<const OwnedDescriptor>(std::move(file));
}

Result<Archive> hold_archive(std::string_view bytes) {
    auto file = memory_file(bytes);
    if (!file) return file.error();
    return std::make_shared<const OwnedDescriptor>(*std::move(file));
}

/// The first of them, for messages.
std::string list_of(const std::vector<std::string>& names) {
    constexpr std::size_t kMostNamed = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) {
        list += (i == 0 ? "" : ", ") + mesh::quoted_token(names[i].substr(0, 200));
    }
    return names.size() > kMostNamed ? list + ", …" : list;
}

Error several(const std::vector<std::string>& models) {
    return {ErrorCode::kArchiveSeveral, "expected one model in the archive, found " +
                                            std::to_string(models.size()) +
                                            "; name one after '#': " + list_of(models)};
}

Error stands_alone(std::string_view name) {
    return {ErrorCode::kGltfBuffer, "expected the file " + mesh::quoted_token(name.substr(0, 200)) +
                                        " that it refers to, found this file alone"};
}

/// The name of the file stands before messages that do not begin with it.
template <typename T>
Result<T> named(Result<T> result, std::string_view name) {
    if (result || result.error().message.starts_with(name)) return result;
    return Error{result.error().code, std::string(name) + ": " + result.error().message};
}

/// Beside the program, or where an installation has it.
fs::path reader_program() {
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path installed = folder.parent_path() / "libexec/ossuary/ossuary-read";
    const fs::path beside = folder / "ossuary-read";
    return !fs::exists(beside, error) && fs::exists(installed, error) ? installed : beside;
}

/// A program of its own, since OpenCASCADE alone takes 40 ms to load. Where it was not built, the
/// other one says so.
fs::path cad_program(const fs::path& program) {
    fs::path beside = program;
    beside += "-cad";
    std::error_code error;
    return fs::exists(beside, error) ? beside : program;
}

}  // namespace

ModelReader::ModelReader() : ModelReader(Options{}) {}

ModelReader::ModelReader(Options options)
    : options_([&] {
          if (options.program.empty()) options.program = reader_program();
          return std::move(options);
      }()) {}

bool ModelReader::is_foreign(mesh::ModelFormat format) {
    using enum mesh::ModelFormat;
    return format == kThreeMf || format == kGltfText || format == kGltfBinary ||
           format == kCollada || format == kX3d || format == kAmf || format == kFbx ||
           format == kStep || format == kIges;
}

Result<std::unique_ptr<ReaderProcess>> ModelReader::take() {
    {
        const Lock lock(mutex_);
        while (!waiting_.empty()) {
            auto process = std::move(waiting_.back());
            waiting_.pop_back();
            if (process->is_usable()) return process;
        }
    }
    return ReaderProcess::start(options_.program, options_.limits);
}

void ModelReader::give_back(std::unique_ptr<ReaderProcess> process) {
    if (!process->is_usable()) return;
    const Lock lock(mutex_);
    if (waiting_.size() < options_.kept) waiting_.push_back(std::move(process));
}

Result<ArchiveModels> ModelReader::models_in(const Archive& archive, const std::stop_token& stop) {
    auto process = take();
    if (!process) return process.error();
    const auto members = (*process)->list(archive->get(), stop);
    give_back(*std::move(process));
    if (!members) return members.error();
    ArchiveModels models;
    for (const ArchiveMember& member : *members) {
        if (member.name == kPackageTypes) return ArchiveModels{{}, true};
        const fs::path path = member.name;
        const bool hidden = std::any_of(path.begin(), path.end(), [](const fs::path& part) {
            return is_hidden_name(part.native());
        });
        if (!hidden && mesh::is_model_file(path) && !is_archive_name(path)) {
            models.names.push_back(member.name);
        }
    }
    return models;
}

Result<WholeFile> ModelReader::unpack(const Archive& archive, const UnpackRequest& request,
                                      const std::stop_token& stop) {
    auto process = take();
    if (!process) return process.error();
    auto bytes = (*process)->unpack(archive->get(), request, stop);
    give_back(*std::move(process));
    return bytes;
}

Result<ModelBytes> ModelReader::open_member(const Archive& archive, std::string_view name,
                                            const UnpackRequest& request,
                                            const std::stop_token& stop) {
    auto bytes = unpack(archive, request, stop);
    if (!bytes) return bytes.error();
    // One that holds itself would be opened without end.
    if (mesh::recognise_format(bytes->view()) == mesh::ModelFormat::kZip) {
        return {ErrorCode::kFormatUnsupported, "expected a model, found an archive in an archive"};
    }
    const fs::path folder = fs::path(request.member).parent_path();
    const auto companions = [this, archive, folder, stop](
                                std::string_view asked,
                                std::uint64_t most) -> Result<OwnedDescriptor> {
        const std::string member = (folder / asked).lexically_normal().string();
        const auto found = unpack(archive, {member, most}, stop);
        if (found) return memory_file(found->view());
        return {ErrorCode::kGltfBuffer, "expected the file " +
                                            mesh::quoted_token(asked.substr(0, 200)) +
                                            " that it refers to, found none in the archive (" +
                                            found.error().message + ")"};
    };
    return ModelBytes{*std::move(bytes), std::string(name) + "#" + request.member, companions, {}};
}

Result<ModelBytes> ModelReader::open_only_model(const Archive& archive, std::string_view name,
                                                std::uint64_t max_bytes,
                                                const std::stop_token& stop) {
    const auto models = models_in(archive, stop);
    if (!models) return models.error();
    if (models->names.empty()) {
        return {ErrorCode::kArchiveEmpty, "expected a model in the archive, found none"};
    }
    if (models->names.size() > 1) return several(models->names);
    return open_member(archive, name, {models->names.front(), max_bytes}, stop);
}

Result<ModelBytes> ModelReader::open(const fs::path& path, std::uint64_t max_bytes,
                                     const std::stop_token& stop) {
    const ModelPlace place = place_of(path);
    auto opened = [&]() -> Result<ModelBytes> {
        if (!place.member.empty()) {
            auto archive = open_archive(place.file);
            if (!archive) return archive.error();
            return open_member(*archive, place.file.string(), {place.member, max_bytes}, stop);
        }
        Result<WholeFile> file = read_whole_file(place.file, max_bytes);
        if (!file) return file.error();
        if (mesh::recognise_format(file->view()) == mesh::ModelFormat::kZip) {
            auto archive = hold_archive(file->view());
            if (!archive) return archive.error();
            return open_only_model(*archive, place.file.string(), max_bytes, stop);
        }
        const fs::path folder =
            place.file.has_parent_path() ? place.file.parent_path() : fs::path(".");
        return ModelBytes{*std::move(file),
                          place.file.string(),
                          [folder](std::string_view name, std::uint64_t most) {
                              return open_beneath(folder, name, most);
                          },
                          {}};
    }();
    if (opened && !place.object.empty()) {
        opened->object = place.object;
        opened->name = path.string();
    }
    return named(std::move(opened), path.string());
}

Result<ArchiveModels> ModelReader::list_archive(const fs::path& path, const std::stop_token& stop) {
    const auto archive = named(open_archive(path), path.string());
    if (!archive) return archive.error();
    return named(models_in(*archive, stop), path.string());
}

Result<mesh::ReadMeshResult> ModelReader::read(const fs::path& path,
                                               const voxel::ReadModelOptions& options,
                                               const std::stop_token& stop) {
    const auto model = open(path, options.mesh.max_bytes, stop);
    if (!model) return model.error();
    return read(Source{model->bytes.view(), model->name, model->companions, model->object}, options,
                stop);
}

Result<ModelReader::WholeModel> ModelReader::read_to_split(const Source& source,
                                                           const voxel::ReadModelOptions& options,
                                                           const std::stop_token& stop) {
    const std::string hash = hash_with_companions(source.bytes, source.companions);
    {
        const Lock lock(mutex_);
        if (split_ != nullptr && split_hash_ == hash) return split_;
    }
    auto read_all = read({source.bytes, source.name, source.companions, {}}, options, stop);
    if (!read_all) return read_all.error();
    auto whole = std::make_shared<const mesh::ReadMeshResult>(*std::move(read_all));
    const Lock lock(mutex_);
    split_hash_ = hash;
    split_ = whole;
    return whole;
}

Result<std::vector<std::string>> ModelReader::list_objects(const fs::path& path,
                                                           const voxel::ReadModelOptions& options,
                                                           const std::stop_token& stop) {
    const auto model = open(path, options.mesh.max_bytes, stop);
    if (!model) return model.error();
    const auto whole =
        read_to_split({model->bytes.view(), model->name, model->companions, {}}, options, stop);
    if (!whole) return whole.error();
    return mesh::object_names((*whole)->objects);
}

Result<mesh::ReadMeshResult> ModelReader::read_object(const Source& source,
                                                      const voxel::ReadModelOptions& options,
                                                      const std::stop_token& stop) {
    const auto whole = read_to_split(source, options, stop);
    if (!whole) return whole.error();
    const std::vector<std::string> names = mesh::object_names((*whole)->objects);
    const auto found = std::find(names.begin(), names.end(), source.object);
    if (found == names.end()) {
        return {ErrorCode::kObjectMissing,
                std::string(source.name) + ": expected an object " +
                    mesh::quoted_token(source.object.substr(0, 200)) + ", found " +
                    (names.empty() ? std::string("none with a name") : list_of(names))};
    }
    const auto number = static_cast<std::size_t>(found - names.begin());
    mesh::ReadMeshResult read;
    read.mesh = mesh::object_mesh((*whole)->mesh, (*whole)->objects[number]);
    read.metres_per_unit = (*whole)->metres_per_unit;
    read.up = (*whole)->up;
    return mesh::finish_reading(std::move(read), source.name, options.mesh, stop);
}

Result<mesh::ReadMeshResult> ModelReader::read(const Source& source,
                                               const voxel::ReadModelOptions& options,
                                               const std::stop_token& stop) {
    if (!source.object.empty()) return read_object(source, options, stop);
    const mesh::ModelFormat format = mesh::recognise_format(source.bytes);
    const bool fits = source.bytes.size() <= options.mesh.max_bytes;
    if (format == mesh::ModelFormat::kZip && fits) {
        const auto archive = hold_archive(source.bytes);
        if (!archive) return archive.error();
        const auto model = named(
            open_only_model(*archive, source.name, options.mesh.max_bytes, stop), source.name);
        if (!model) return model.error();
        return read(Source{model->bytes.view(), model->name, model->companions}, options, stop);
    }
    if (!is_foreign(format) || !fits) {
        auto read = voxel::read_model(source.bytes, source.name, options, stop);
        if (read && !read->materials.empty())
            colour_by_libraries(*read, source.bytes, source.companions);
        return read;
    }
    const bool is_cad = format == mesh::ModelFormat::kStep || format == mesh::ModelFormat::kIges;
    auto process =
        is_cad ? ReaderProcess::start(cad_program(options_.program), options_.limits) : take();
    if (!process) return process.error();
    std::uint64_t left = options.mesh.max_bytes;
    const GiveFile give = [&](std::string_view name) -> Result<OwnedDescriptor> {
        if (!source.companions) return stands_alone(name);
        auto opened = source.companions(name, left);
        struct stat status {};
        if (opened && ::fstat(opened->get(), &status) == 0) {
            left -= std::min(left, static_cast<std::uint64_t>(status.st_size));
        }
        return opened;
    };
    auto read = (*process)->read({format, options.mesh}, source.bytes, give, stop);
    if (!is_cad) give_back(*std::move(process));
    if (!read) return named(std::move(read), source.name);
    return mesh::finish_reading(*std::move(read), source.name, options.mesh, stop);
}

Result<OwnedDescriptor> open_beneath(const fs::path& folder, std::string_view name,
                                     std::uint64_t max_bytes) {
    const auto refuse = [&](const std::string& reason) -> Error {
        return {ErrorCode::kGltfBuffer, "expected the file " +
                                            mesh::quoted_token(name.substr(0, 200)) +
                                            " that it refers to, found " + reason};
    };
    if (name.find('\0') != std::string_view::npos) return refuse("no such name");
    const OwnedDescriptor base(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!base.is_open()) return refuse(std::generic_category().message(errno));
    open_how how{};
    // A pipe would keep the caller waiting.
    how.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK;
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
    OwnedDescriptor file(static_cast<int>(
        ::syscall(SYS_openat2, base.get(), std::string(name).c_str(), &how, sizeof(how))));
    if (!file.is_open()) {
        return refuse(errno == EXDEV ? std::string("one outside its folder")
                                     : std::generic_category().message(errno));
    }
    struct stat status {};
    if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
        return refuse("no regular file");
    }
    if (static_cast<std::uint64_t>(status.st_size) > max_bytes) return refuse("one too large");
    return file;
}

}  // namespace ossuary::index
