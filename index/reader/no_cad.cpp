// In the place of read_cad.cpp where OpenCASCADE was not there when the program was built.
#include <string>

#include "index/reader/read_cad.h"

namespace ossuary::index {

Result<mesh::ReadMeshResult> read_cad(std::string_view, mesh::ModelFormat format,
                                      const mesh::ReadMeshOptions&) {
    return {ErrorCode::kFormatUnsupported,
            "expected a format that this program was built for, found " +
                std::string(to_string(format)) + ", which needs OpenCASCADE"};
}

}  // namespace ossuary::index
