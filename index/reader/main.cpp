// ossuary-read: reads model files with other people's libraries, one after the other, for the
// programs that start it. It speaks over descriptor 3 (see protocol.h) and can do nothing else.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

#include "index/reader/companions.h"
#include "index/reader/confinement.h"
#include "index/reader/protocol.h"
#include "index/reader/read_archive.h"
#include "index/reader/read_cad.h"
#include "index/reader/read_gltf.h"
#include "index/reader/read_scene.h"
#include "index/reader/read_three_mf.h"

namespace {

using namespace ossuary;
using namespace ossuary::index;

constexpr int kChannel = 3;
constexpr int kUsage = 2;

/// Asks the program for a file that the model refers to.
Result<OwnedDescriptor> ask_for_file(std::string_view name) {
    const Error gone = {ErrorCode::kInternal, "the program has gone"};
    if (!send_packet(kChannel, text_message(MessageKind::kNeed, name))) return gone;
    auto answer = receive_packet(kChannel);
    if (!answer) return answer.error();
    if (kind_of(answer->bytes) == MessageKind::kGive && answer->descriptors.size() == 1) {
        return std::move(answer->descriptors.front());
    }
    return {ErrorCode::kGltfBuffer, std::string(text_of(answer->bytes))};
}

Result<mesh::ReadMeshResult> read_model(const ReadRequest& request, std::string_view bytes) {
    switch (request.format) {
        case mesh::ModelFormat::kThreeMf:
            return read_three_mf(bytes, request.caps);
        case mesh::ModelFormat::kGltfText:
        case mesh::ModelFormat::kGltfBinary:
            return read_gltf(bytes, request.caps, ask_for_file);
        case mesh::ModelFormat::kCollada:
        case mesh::ModelFormat::kX3d:
        case mesh::ModelFormat::kAmf:
        case mesh::ModelFormat::kFbx:
            return read_scene(bytes, request.format, request.caps);
        case mesh::ModelFormat::kStep:
        case mesh::ModelFormat::kIges:
            return read_cad(bytes, request.format, request.caps);
        default:
            return {ErrorCode::kFormatUnsupported, "expected a format that this program reads"};
    }
}

Result<std::string> answer_read(std::string_view message, std::string_view bytes, int answer) {
    const auto request = decode_request(message);
    if (!request) return request.error();
    const auto read = read_model(*request, bytes);
    if (!read) return read.error();
    return write_answer(*read, answer);
}

Result<std::string> answer_list(std::string_view bytes, int answer) {
    const auto members = list_archive(bytes);
    if (!members) return members.error();
    return write_members(*members, answer);
}

Result<std::string> answer_unpack(std::string_view message, std::string_view bytes, int answer) {
    const auto request = decode_unpack(message);
    if (!request) return request.error();
    const auto member = unpack_member(bytes, *request);
    if (!member) return member.error();
    return write_unpacked(*member, answer);
}

/// The message that answers a request. Nothing of the file is held any more when it is there.
Result<std::string> answer(const Packet& packet) {
    if (packet.descriptors.size() != 2) {
        return {ErrorCode::kInternal, "expected two files with a request"};
    }
    const auto file = MappedFile::open(packet.descriptors[0].get());
    if (!file) return file.error();
    const int into = packet.descriptors[1].get();
    switch (kind_of(packet.bytes)) {
        case MessageKind::kList:
            return answer_list(file->view(), into);
        case MessageKind::kUnpack:
            return answer_unpack(packet.bytes, file->view(), into);
        default:
            return answer_read(packet.bytes, file->view(), into);
    }
}

Result<std::string> answer_checked(const Packet& packet) {
    try {
        return answer(packet);
    } catch (const std::bad_alloc&) {
        return {ErrorCode::kReaderMemory, "expected a file that can be read in the memory given"};
    } catch (const std::exception& exception) {
        return {ErrorCode::kReaderCrashed, std::string("the library failed: ") + exception.what()};
    }
}

/// @returns whether another request may come
bool serve_one() {
    const auto packet = receive_packet(kChannel);
    if (!packet || packet->bytes.empty()) return false;
    const auto message = answer_checked(*packet);
    if (message) return send_packet(kChannel, *message);
    const ErrorCode code = message.error().code;
    return send_packet(kChannel, encode_fault(message.error())) &&
           code != ErrorCode::kReaderMemory && code != ErrorCode::kReaderCrashed;
}

bool is_socket(int descriptor) {
    int type = 0;
    socklen_t size = sizeof(type);
    return getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_SEQPACKET;
}

}  // namespace

int main(int argc, char** argv) {
    ConfinementLimits limits;
    const std::string_view memory = argc == 2 ? argv[1] : "";
    const auto parsed =
        std::from_chars(memory.data(), memory.data() + memory.size(), limits.memory_bytes);
    if (memory.empty() || parsed.ptr != memory.data() + memory.size() || !is_socket(kChannel)) {
        constexpr std::string_view kText =
            "ossuary-read reads models for ossuary and ossuary-server, which start it "
            "themselves.\n";
        return write_all(STDERR_FILENO, kText.data(), kText.size()) ? kUsage : 1;
    }
    const std::string fault = confine(limits);
    if (!send_packet(kChannel, text_message(MessageKind::kReady, fault)) || !fault.empty()) {
        return 1;
    }
    while (serve_one()) {
    }
    return 0;
}
