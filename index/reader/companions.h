#pragma once

#include <functional>
#include <string_view>

#include "engine/core/result.h"
#include "index/reader/channel.h"

namespace ossuary::index {

/// Asks for a file that a model refers to, by the name that the model gives.
using AskForFile = std::function<Result<OwnedDescriptor>(std::string_view name)>;

/// A file's bytes, mapped into memory for as long as this lives.
class MappedFile {
public:
    MappedFile() = default;
    MappedFile(MappedFile&& other) noexcept
        : bytes_(std::exchange(other.bytes_, std::string_view())) {}
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    MappedFile& operator=(MappedFile&&) = delete;
    ~MappedFile();

    /// Errors: reader_memory.
    static Result<MappedFile> open(int descriptor);

    [[nodiscard]] std::string_view view() const { return bytes_; }

private:
    std::string_view bytes_;
};

}  // namespace ossuary::index
