// Blobs of earlier versions of the program.

#include "tests/index/earlier_versions.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "index/bytes.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

using test::earlier_descriptor;
using test::earlier_preview;
using test::sealed_as;

TEST(EarlierVersions, OfDescriptorsAreReadInFull) {
    matching::SkeletonDescriptor descriptor = test::sample_model(4, "/x").descriptor.skeleton;
    ASSERT_GT(descriptor.limb_volume, 0.0F);
    descriptor.limb_volume = 0.0F;  // earlier versions have none
    const auto second = decode_descriptor(earlier_descriptor(descriptor, 2));
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_EQ(encode_descriptor(*second), encode_descriptor(descriptor));
    const auto first = decode_descriptor(earlier_descriptor(descriptor, 1));
    ASSERT_TRUE(first) << first.error().message;
    EXPECT_EQ(first->solid_volume, 0.0F) << "version 1 has none";
    descriptor.solid_volume = 0.0F;
    EXPECT_EQ(encode_descriptor(*first), encode_descriptor(descriptor));
}

TEST(EarlierVersions, OfGlobalsKeepNamesAndLengths) {
    const auto blob = [](float last) {
        ByteWriter writer;
        writer.put(std::uint32_t{1});
        writer.put_text("d2");
        writer.put(std::uint32_t{3});
        writer.put_all<float>(std::vector<float>{0.5F, 1.0F, last});
        return sealed_as(kGlobalsBlob, 1, writer.bytes());
    };
    const auto read = decode_globals(blob(2.0F));
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->size(), 1U);
    EXPECT_EQ(read->front().name, "d2");
    EXPECT_EQ(read->front().values.size(), 3U);
    EXPECT_FALSE(decode_globals(blob(std::numeric_limits<float>::infinity())));
}

TEST(Codec, ReadsPreviewsOfVersionOneAboutTheFilesOrigin) {
    const std::string blob = std::string("MESH\x01\0\0\0", 8);
    const auto text = [](auto number) {
        return std::string(reinterpret_cast<const char*>(&number), sizeof number);
    };
    std::string bytes = blob + text(std::uint32_t{3}) + text(std::uint32_t{1}) + '\x02';
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 5.F}) bytes += text(x);
    for (std::uint16_t v = 0; v < 3; ++v) bytes += text(v);
    bytes += text(XXH3_64bits(bytes.data(), bytes.size()));
    const auto decoded = decode_preview(bytes);
    ASSERT_TRUE(decoded) << decoded.error().message;
    EXPECT_EQ(decoded->origin, Vec3(0, 0, 0));
    EXPECT_EQ(decoded->positions.back(), 5.F);
    EXPECT_EQ(decoded->colours, PreviewColours{});
}

TEST(EarlierVersions, OfPreviewsAreReadInFull) {
    PreviewMesh mesh = test::sample_model(1, "").preview;
    mesh.origin = {1.0, -2.5, 1e6};
    const auto third = decode_preview(earlier_preview(mesh, 3));
    ASSERT_TRUE(third) << third.error().message;
    EXPECT_EQ(encode_preview(*third), encode_preview(mesh));
    const auto second = decode_preview(earlier_preview(mesh, 2));
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_EQ(second->colours, PreviewColours{}) << "version 2 has none";
    EXPECT_EQ(second->positions, mesh.positions);
}

TEST(EarlierVersions, OfSkeletonsAreReadInFull) {
    const skeleton::SkeletonGraph graph = test::sample_model(4, "/x").skeleton;
    ByteWriter writer;
    const auto put = [&](const Vec3& point) {
        for (const double coordinate : point) writer.put(coordinate);
    };
    writer.put(static_cast<std::uint32_t>(graph.nodes.size()));
    for (const auto& node : graph.nodes) {
        put(node.position);
        writer.put(node.radius);
        writer.put(node.significance);
        writer.put(static_cast<std::int32_t>(node.degree));
    }
    writer.put(static_cast<std::uint32_t>(graph.branches.size()));
    for (const auto& branch : graph.branches) {
        writer.put(branch.a);
        writer.put(branch.b);
        writer.put(static_cast<std::uint32_t>(branch.points.size()));
        for (const Vec3& point : branch.points) put(point);
        writer.put_all<double>(branch.radii);
    }
    const auto read = decode_skeleton(sealed_as(kSkeletonBlob, 1, writer.bytes()));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(encode_skeleton(*read), encode_skeleton(graph));
}

TEST(EarlierVersions, OfGlobalsAreNotPacked) {
    const auto globals = test::sample_model(4, "/x").descriptor.globals;
    ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(globals.size()));
    for (const auto& global : globals) {
        writer.put_text(global.name);
        writer.put(static_cast<std::uint32_t>(global.values.size()));
        writer.put_all<std::uint8_t>(global.values);
    }
    const auto read = decode_globals(sealed_as(kGlobalsBlob, 2, writer.bytes()));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(encode_globals(*read), encode_globals(globals));
}

TEST(EarlierVersions, OfSegmentsHaveALabelForEachTriangle) {
    for (const std::uint32_t count : {2U, 300U}) {  // labels of one byte and of four
        ByteWriter writer;
        writer.put(count);
        for (std::uint32_t p = 0; p < count; ++p) {
            writer.put(0.5);
            writer.put(std::int32_t{-1});
            writer.put(std::uint32_t{0});
        }
        writer.put(2 * count);
        std::vector<std::uint32_t> labels;
        for (std::uint32_t t = 0; t < 2 * count; ++t) {
            labels.push_back(t % count);
            if (count > 256) {
                writer.put(labels.back());
            } else {
                writer.put(static_cast<std::uint8_t>(labels.back()));
            }
        }
        const auto read = decode_segments(sealed_as(kSegmentsBlob, 1, writer.bytes()));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->labels, labels);
        EXPECT_EQ(read->parts.size(), count);
    }
}

}  // namespace
}  // namespace ossuary::index
