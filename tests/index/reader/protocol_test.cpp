#include "index/reader/protocol.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

mesh::ReadMeshResult sample() {
    mesh::ReadMeshResult read;
    read.mesh = test::torus_mesh(1.0, 0.3);
    read.warnings = {{"odd", 3, "three odd things"}};
    read.metres_per_unit = 0.001;
    read.up = mesh::UpAxis::kZ;
    read.objects = {{"ring", 0, static_cast<std::uint32_t>(read.mesh.triangles.size())}};
    return read;
}

struct Answer {
    std::string message;
    OwnedDescriptor file;
};

Answer answer_of(const mesh::ReadMeshResult& read) {
    auto file = memory_file();
    EXPECT_TRUE(file);
    auto message = write_answer(read, file->get());
    EXPECT_TRUE(message);
    return {*std::move(message), *std::move(file)};
}

TEST(ReaderProtocol, BringsAMeshOverWhole) {
    mesh::ReadMeshResult read = sample();
    // Two triangles of one polygon: the faces travel too.
    read.mesh.face_of_triangle[1] = 0;
    for (std::size_t t = 2; t < read.mesh.triangles.size(); ++t) read.mesh.face_of_triangle[t] -= 1;
    read.mesh.face_count -= 1;
    const Answer answer = answer_of(read);
    const auto back = read_answer(answer.message, answer.file.get(), {});
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->mesh.vertices, read.mesh.vertices);
    EXPECT_EQ(back->mesh.triangles, read.mesh.triangles);
    EXPECT_EQ(back->mesh.face_of_triangle, read.mesh.face_of_triangle);
    EXPECT_EQ(back->mesh.face_count, read.mesh.face_count);
    EXPECT_EQ(back->metres_per_unit, 0.001);
    EXPECT_EQ(back->up, mesh::UpAxis::kZ);
    ASSERT_EQ(back->warnings.size(), 1u);
    EXPECT_EQ(back->warnings[0].message, "three odd things");
    ASSERT_EQ(back->objects.size(), 1u);
    EXPECT_EQ(back->objects[0].name, "ring");
    EXPECT_EQ(back->objects[0].triangles, read.mesh.triangles.size());
}

TEST(ReaderProtocol, TrustsNoNumberOfAnAnswer) {
    const auto refused = [](mesh::ReadMeshResult read, const mesh::ReadMeshOptions& caps = {}) {
        const Answer answer = answer_of(read);
        const auto back = read_answer(answer.message, answer.file.get(), caps);
        return !back && back.error().code == ErrorCode::kReaderCrashed;
    };
    EXPECT_FALSE(refused(sample()));
    mesh::ReadMeshResult read = sample();
    read.mesh.triangles[5][1] = static_cast<std::uint32_t>(read.mesh.vertices.size());
    EXPECT_TRUE(refused(read));
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), 1e31,
                               std::numeric_limits<double>::infinity()}) {
        read = sample();
        read.mesh.vertices[3].y() = wrong;
        EXPECT_TRUE(refused(read)) << wrong;
    }
    read = sample();
    read.mesh.face_of_triangle[0] = read.mesh.face_count;
    EXPECT_TRUE(refused(read));
    read = sample();
    read.objects[0].triangles += 1;
    EXPECT_TRUE(refused(read));
    read = sample();
    read.objects[0].first_triangle = 0xFFFFFFFF;
    EXPECT_TRUE(refused(read));
    mesh::ReadMeshOptions caps;
    caps.max_vertices = 10;
    EXPECT_TRUE(refused(sample(), caps));
}

TEST(ReaderProtocol, SurvivesDamagedAnswers) {
    const Answer answer = answer_of(sample());
    std::mt19937_64 random(5);
    for (int round = 0; round < 2000; ++round) {
        std::string message = answer.message;
        if (round % 3 == 0) {
            message.resize(random() % message.size());
        } else {
            message[random() % message.size()] = static_cast<char>(random() % 256);
        }
        const auto back = read_answer(message, answer.file.get(), {});
        if (!back) {
            ASSERT_EQ(back.error().code, ErrorCode::kReaderCrashed);
        }
    }
}

TEST(ReaderProtocol, BringsRequestsAndFaultsOver) {
    ReadRequest request;
    request.format = mesh::ModelFormat::kGltfBinary;
    request.caps.max_vertices = 7;
    const auto back = decode_request(encode_request(request));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->format, request.format);
    EXPECT_EQ(back->caps.max_vertices, 7u);
    EXPECT_FALSE(decode_request(encode_request(request) + "x"));
    EXPECT_FALSE(decode_request(""));
    const Error error =
        decode_fault(encode_fault({ErrorCode::kGltfInvalid, "expected a, found b"}));
    EXPECT_EQ(error.code, ErrorCode::kGltfInvalid);
    EXPECT_EQ(error.message, "expected a, found b");
    EXPECT_EQ(decode_fault("").code, ErrorCode::kReaderCrashed);
    EXPECT_EQ(decode_fault(text_message(MessageKind::kFault, "no_such_code x")).code,
              ErrorCode::kReaderCrashed);
}

}  // namespace
}  // namespace ossuary::index
