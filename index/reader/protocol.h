#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/whole_file.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/recognise_format.h"
#include "index/reader/channel.h"

// What the programs and `ossuary-read` say to each other, over a socket that keeps messages apart.
// The program asks with a file and an empty memory file for the answer; the reader may ask back for
// files that a model refers to, any number of times; then it answers. A program
// trusts nothing that comes back: every number is looked at again on its own copy.
namespace ossuary::index {

enum class MessageKind : std::uint8_t {
    kReady = 1,  ///< reader: confined, and waiting for work; an error text where it could not be
    kRead,       ///< program: a model, with its file and one for the answer
    kList,       ///< program: an archive, likewise
    kUnpack,     ///< program: the name of a member of an archive, likewise
    kNeed,       ///< reader: the name of a file that the model refers to
    kGive,       ///< program: that file
    kRefuse,     ///< program: why not
    kMesh,       ///< reader: how much there is of a mesh in the answer's file
    kMembers,    ///< reader: how much there is of a list in the answer's file
    kUnpacked,   ///< reader: how much there is of a member in the answer's file
    kFault,      ///< reader: why there is no answer
};

/// The first byte; kFault for an empty message.
[[nodiscard]] MessageKind kind_of(std::string_view message);

/// A message of a kind and one text.
[[nodiscard]] std::string text_message(MessageKind kind, std::string_view text);
[[nodiscard]] std::string_view text_of(std::string_view message);

struct ReadRequest {
    mesh::ModelFormat format = mesh::ModelFormat::kUnknown;
    mesh::ReadMeshOptions caps;
};
[[nodiscard]] std::string encode_request(const ReadRequest& request);
/// Errors: internal.
Result<ReadRequest> decode_request(std::string_view message);

/// A file in an archive.
struct ArchiveMember {
    std::string name;
    std::uint64_t size = 0;  ///< bytes unpacked, as the archive says
};
/// The longest name that is listed, and can be asked for.
inline constexpr std::size_t kLongestMember = 4000;

struct UnpackRequest {
    std::string member;
    std::uint64_t max_bytes = 0;
};
[[nodiscard]] std::string encode_unpack(const UnpackRequest& request);
/// Errors: internal.
Result<UnpackRequest> decode_unpack(std::string_view message);

/// Writes a list of members, or one of them, into the answer's file and returns the message that
/// says so. Errors: reader_memory where it is too much for the file.
Result<std::string> write_members(const std::vector<ArchiveMember>& members, int file);
Result<std::string> write_unpacked(std::string_view bytes, int file);

/// Takes them from there. Errors: reader_crashed where that is not what a whole reader gives.
Result<std::vector<ArchiveMember>> read_members(std::string_view message, int file);
Result<WholeFile> read_unpacked(std::string_view message, int file, std::uint64_t max_bytes);

[[nodiscard]] std::string encode_fault(const Error& error);
/// What a fault says; reader_crashed where it makes no sense.
[[nodiscard]] Error decode_fault(std::string_view message);

/// Writes a mesh into the answer's file and returns the message that says what is there.
/// Errors: reader_memory where it is too much for the file.
Result<std::string> write_answer(const mesh::ReadMeshResult& read, int file);

/// Takes a mesh from the answer's file.
/// Errors: reader_crashed where the answer is not one that a whole reader gives: counts beyond the
/// caps or the file, indices out of range, numbers not finite.
Result<mesh::ReadMeshResult> read_answer(std::string_view message, int file,
                                         const mesh::ReadMeshOptions& caps);

}  // namespace ossuary::index
