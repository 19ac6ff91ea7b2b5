// In the place of read_cad.cpp in ossuary-read, which is asked for STEP and IGES only where
// ossuary-read-cad is not there.
#include <string>

#include "index/reader/read_cad.h"

namespace ossuary::index {

Result<mesh::ReadMeshResult> read_cad(std::string_view, mesh::ModelFormat format,
                                      const mesh::ReadMeshOptions&) {
    return {ErrorCode::kFormatUnsupported,
            "expected a format that this program was built for, found " +
                std::string(to_string(format)) +
                ", which needs OpenCASCADE (ossuary-read-cad is not there)"};
}

}  // namespace ossuary::index
