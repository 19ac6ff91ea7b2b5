#include "index/model_reader.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "engine/core/whole_file.h"
#include "engine/mesh/recognise_format.h"
#include "engine/mesh/text_scanner.h"
#include "engine/voxel/read_model.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

fs::path beside_this_program() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path() / "ossuary-read";
}

}  // namespace

ModelReader::ModelReader() : ModelReader(Options{}) {}

ModelReader::ModelReader(Options options)
    : options_([&] {
          if (options.program.empty()) options.program = beside_this_program();
          return std::move(options);
      }()) {}

bool ModelReader::is_foreign(mesh::ModelFormat format) {
    using enum mesh::ModelFormat;
    return format == kThreeMf || format == kGltfText || format == kGltfBinary ||
           format == kCollada || format == kX3d || format == kAmf || format == kFbx;
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

Result<mesh::ReadMeshResult> ModelReader::read(const fs::path& path,
                                               const mesh::ReadMeshOptions& caps,
                                               const std::stop_token& stop) {
    const Result<WholeFile> file = read_whole_file(path, caps.max_bytes);
    if (!file) return file.error();
    const std::string name = path.string();
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    return read(Source{file->view(), name, folder}, caps, stop);
}

Result<mesh::ReadMeshResult> ModelReader::read(const Source& source,
                                               const mesh::ReadMeshOptions& caps,
                                               const std::stop_token& stop) {
    const mesh::ModelFormat format = mesh::recognise_format(source.bytes);
    if (!is_foreign(format) || source.bytes.size() > caps.max_bytes) {
        return voxel::read_model(source.bytes, source.name, {caps, {}}, stop);
    }
    auto process = take();
    if (!process) return process.error();
    std::uint64_t left = caps.max_bytes;
    const GiveFile give = [&](std::string_view name) -> Result<OwnedDescriptor> {
        auto opened = open_beneath(source.folder, name, left);
        struct stat status {};
        if (opened && ::fstat(opened->get(), &status) == 0) {
            left -= std::min(left, static_cast<std::uint64_t>(status.st_size));
        }
        return opened;
    };
    auto read = (*process)->read({format, caps}, source.bytes, give, stop);
    give_back(*std::move(process));
    if (!read) return {read.error().code, std::string(source.name) + ": " + read.error().message};
    return mesh::finish_reading(*std::move(read), source.name, caps, stop);
}

Result<OwnedDescriptor> open_beneath(const fs::path& folder, std::string_view name,
                                     std::uint64_t max_bytes) {
    const auto refuse = [&](const std::string& reason) -> Error {
        return {ErrorCode::kGltfBuffer, "expected the file " +
                                            mesh::quoted_token(name.substr(0, 200)) +
                                            " that it refers to, found " + reason};
    };
    if (folder.empty()) return refuse("this file alone");
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
