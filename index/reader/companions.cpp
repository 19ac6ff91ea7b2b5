#include "index/reader/companions.h"

#include <sys/mman.h>
#include <sys/stat.h>

namespace ossuary::index {

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

Result<MappedFile> MappedFile::open(int descriptor) {
    struct stat status {};
    MappedFile file;
    if (::fstat(descriptor, &status) != 0 || status.st_size < 0) {
        return {ErrorCode::kInternal, "expected a file, found none"};
    }
    if (status.st_size == 0) return file;
    const auto size = static_cast<std::size_t>(status.st_size);
    // Written to as well: some libraries take their input as if it were theirs.
    void* at = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE, descriptor, 0);
    if (at == MAP_FAILED) {
        return {ErrorCode::kReaderMemory,
                "expected room for " + std::to_string(size) + " bytes, found none"};
    }
    file.bytes_ = {static_cast<const char*>(at), size};
    return file;
}

}  // namespace ossuary::index
