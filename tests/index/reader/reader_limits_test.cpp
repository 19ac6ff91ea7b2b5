// A file that goes too far costs its reader's life, is refused under one code, and the next file is
// read as if nothing had been.

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>

#include "engine/core/whole_file.h"
#include "index/model_reader.h"
#include "index/reader/confinement.h"
#include "tests/support/source_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

fs::path write_text(const fs::path& path, const std::string& text) {
    if (!write_whole_file(path, text)) throw std::runtime_error("no file");
    return path;
}

/// Objects of two components each, every one the object before it: 2^levels empty meshes.
std::string doubling_components(int levels) {
    std::string resources =
        R"(<object id="1" type="model"><mesh><vertices/><triangles/></mesh></object>)";
    for (int level = 2; level <= levels + 1; ++level) {
        const std::string before = "<component objectid=\"" + std::to_string(level - 1) + "\"/>";
        resources += "<object id=\"" + std::to_string(level) + "\" type=\"model\"><components>" +
                     before + before + "</components></object>";
    }
    return test::three_mf_part(resources,
                               "<item objectid=\"" + std::to_string(levels + 1) + "\"/>");
}

/// Extras nested deeper than any stack.
std::string deep_document() {
    constexpr int kDepth = 1'000'000;
    std::string text = R"({"asset":{"version":"2.0"},"extras":)";
    for (int i = 0; i < kDepth; ++i) text += '[';
    text += '0';
    for (int i = 0; i < kDepth; ++i) text += ']';
    return text + "}";
}

class ReaderLimits : public testing::Test {
protected:
    test::TemporaryFolder folder_;

    static void expect_that_it_goes_on(ModelReader& reader) {
        const auto read = reader.read(test::source_folder() / "tests/corpus/3mf/ok/one_item.3mf");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->mesh.triangles.size(), 4u);
    }
    static void expect_refusal(ModelReader& reader, const fs::path& file, ErrorCode code) {
        for (int round = 0; round < 2; ++round) {
            const auto read = reader.read(file);
            ASSERT_FALSE(read);
            EXPECT_EQ(read.error().code, code) << read.error().message;
            EXPECT_EQ(read.error().message.rfind(file.string() + ": ", 0), 0u);
            expect_that_it_goes_on(reader);
        }
    }
};

TEST_F(ReaderLimits, EndAFileThatTakesTooMuchProcessorTime) {
    ModelReader::Options options;
    options.limits.processor_time = std::chrono::seconds(1);
    ModelReader reader(options);
    expect_refusal(reader,
                   test::write_three_mf(folder_.path() / "doubling.3mf", doubling_components(60)),
                   ErrorCode::kReaderTime);
}

TEST_F(ReaderLimits, EndAFileThatTakesTooLong) {
    ModelReader::Options options;
    options.limits.time = std::chrono::milliseconds(300);
    ModelReader reader(options);
    expect_refusal(reader,
                   test::write_three_mf(folder_.path() / "doubling.3mf", doubling_components(60)),
                   ErrorCode::kReaderTime);
}

TEST_F(ReaderLimits, EndAFileThatTakesTooMuchMemory) {
    if (!can_be_confined()) GTEST_SKIP() << "this build cannot be held within an address space";
    ModelReader::Options options;
    options.limits.memory_bytes = 200u << 20;
    ModelReader reader(options);
    // A few hundred bytes that stand for 4,900,000 vertices.
    const fs::path file = write_text(
        folder_.path() / "zeros.gltf",
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":)"
        R"(5126,"count":4900000,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":0,)"
        R"("componentType":5121},"values":{"bufferView":1}}}],"bufferViews":[{"buffer":0,)"
        R"("byteLength":4},{"buffer":0,"byteOffset":4,"byteLength":12}],"buffers":[{"byteLength":)"
        R"(16,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAA=="}]})");
    expect_refusal(reader, file, ErrorCode::kReaderMemory);
    ModelReader roomy;
    const auto read = roomy.read(file);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.vertices.size(), 1u);
}

TEST_F(ReaderLimits, EndAFileThatEndsItsReader) {
    const fs::path file = write_text(folder_.path() / "deep.gltf", deep_document());
    ModelReader reader;
    expect_refusal(reader, file, ErrorCode::kReaderCrashed);
    // Sanitizers end the process in their own way.
    if (!can_be_confined()) return;
    EXPECT_NE(reader.read(file).error().message.find("SIGSEGV"), std::string::npos);
}

TEST_F(ReaderLimits, EndAFileThatNobodyWaitsFor) {
    const fs::path file =
        test::write_three_mf(folder_.path() / "doubling.3mf", doubling_components(60));
    ModelReader reader;
    std::stop_source stop;
    std::jthread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stop.request_stop();
    });
    const auto started = std::chrono::steady_clock::now();
    const auto read = reader.read(file, {}, stop.get_token());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kCancelled);
    EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(20));
    expect_that_it_goes_on(reader);
}

}  // namespace
}  // namespace ossuary::index
