#pragma once

#include <string_view>

namespace ossuary::index {

/// OpenCASCADE reads IGES from files that it opens by name alone, and this process can open none:
/// while one of these lives, the name kIgesFile stands for its bytes.
class IgesFile {
public:
    /// @param bytes  must outlive this
    explicit IgesFile(std::string_view bytes);
    IgesFile(const IgesFile&) = delete;
    IgesFile& operator=(const IgesFile&) = delete;
    ~IgesFile();
};
inline constexpr const char* kIgesFile = "model.igs";

}  // namespace ossuary::index
