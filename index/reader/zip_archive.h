#pragma once

#include <zip.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace ossuary::index {

/// A ZIP archive in memory, read by libzip.
class ZipArchive {
public:
    struct Member {
        std::string name;        ///< UTF-8, as libzip takes names that do not say what they are
        std::uint64_t size = 0;  ///< bytes unpacked, as the archive says
        bool encrypted = false;
    };

    /// @param bytes  must outlive this
    /// Errors: archive_invalid.
    static Result<ZipArchive> open(std::string_view bytes);

    [[nodiscard]] std::uint64_t size() const;
    /// A member by its number; none where the archive does not describe it.
    [[nodiscard]] std::optional<Member> member(std::uint64_t number) const;
    /// The number of the first member of a name.
    [[nodiscard]] std::optional<std::uint64_t> find(const std::string& name) const;

    /// A member's beginning, unpacked: all of it where it is no longer than `most`.
    /// Errors: archive_invalid.
    [[nodiscard]] Result<std::string> read(std::uint64_t number, std::size_t most) const;

private:
    struct Close {
        void operator()(zip_t* archive) const { zip_discard(archive); }
    };
    explicit ZipArchive(zip_t* archive) : archive_(archive) {}

    std::unique_ptr<zip_t, Close> archive_;
};

}  // namespace ossuary::index
