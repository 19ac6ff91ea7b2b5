#include "index/reader/iges_file.h"

#include <cerrno>
#include <cstdio>

namespace ossuary::index {
namespace {

/// One thread reads one model at a time in this process.
std::string_view bytes_of_model;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

IgesFile::IgesFile(std::string_view bytes) { bytes_of_model = bytes; }
IgesFile::~IgesFile() { bytes_of_model = {}; }

}  // namespace ossuary::index

/// What OpenCASCADE's reader of IGES opens files with; the program's own comes before the
/// library's.
extern "C" std::FILE* OSD_OpenFile(const char* name, const char* mode) {
    using namespace ossuary::index;
    if (std::string_view(name) != kIgesFile || bytes_of_model.empty()) {
        errno = ENOENT;
        return nullptr;
    }
    // Read only: the mode says so as well.
    return ::fmemopen(const_cast<char*>(bytes_of_model.data()), bytes_of_model.size(), mode);
}
