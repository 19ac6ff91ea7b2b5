#include "index/codec.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <cmath>
#include <functional>
#include <limits>

#include "index/blob.h"
#include "index/bytes.h"
#include "index/content_hash.h"
#include "index/packed_bytes.h"
#include "index/round_skeleton.h"
#include "index/scan_block.h"
#include "tests/index/earlier_versions.h"
#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

/// A kind of blob: one example, and what decoding and encoding again makes of any bytes (none when
/// decoding refuses).
struct Case {
    std::string name;
    BlobKind kind;
    std::string blob;
    std::function<Result<std::string>(std::string_view)> recode;
    bool packed = false;  ///< several blobs may say the same
};

template <typename Decode, typename Encode>
auto recoder(const Decode& decode, const Encode& encode) {
    return [decode, encode](std::string_view blob) -> Result<std::string> {
        const auto value = decode(blob);
        if (!value) return value.error();
        return encode(*value);
    };
}

ScanBlock sample_block() {
    ScanBlock block;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const NewModel model = test::sample_model(seed, "/m/x.off");
        block.append(static_cast<ModelId>(seed), 7, 100 + seed, model.summary.class_name);
        block.rows.append(model.descriptor);
    }
    return block;
}

std::vector<Case> cases() {
    const NewModel model = test::sample_model(4, "/models/x.off");
    return {
        {"skeleton", kSkeletonBlob, encode_skeleton(model.skeleton),
         recoder(decode_skeleton, encode_skeleton), true},
        {"descriptor", kDescriptorBlob, encode_descriptor(model.descriptor.skeleton),
         recoder(decode_descriptor, encode_descriptor)},
        {"globals", kGlobalsBlob, encode_globals(model.descriptor.globals),
         recoder(decode_globals, encode_globals), true},
        {"signature", kSignatureBlob, encode_signature(model.descriptor.signature),
         recoder(decode_signature, encode_signature)},
        {"preview", kPreviewBlob, encode_preview(model.preview),
         recoder(decode_preview, encode_preview), true},
        {"segments", kSegmentsBlob, encode_segments(*model.segments),
         recoder(decode_segments, encode_segments)},
        {"features", kFeaturesBlob, encode_features(model.features),
         recoder(decode_features, encode_features), true},
        {"thumbnail", kThumbnailBlob, encode_thumbnail(model.thumbnail),
         recoder(decode_thumbnail, encode_thumbnail)},
        {"statistics", kStatisticsBlob, encode_statistics({{1.0, -0.0, 1e-310, 3.25}}),
         recoder(decode_statistics, encode_statistics)},
        {"report", kEvaluationBlob, encode_report(test::sample_report(1)),
         recoder(decode_report, encode_report)},
        {"scan", kScanBlob, encode_scan_block(sample_block()),
         recoder(decode_scan_block, encode_scan_block)},
    };
}

/// The blob with a checksum that is right for its contents, as a liar would make it.
std::string with_checksum(std::string blob) {
    blob.resize(blob.size() - kBlobTrailerSize);
    ByteWriter trailer;
    trailer.put(static_cast<std::uint64_t>(XXH3_64bits(blob.data(), blob.size())));
    return blob + trailer.bytes();
}

class CodecTest : public testing::TestWithParam<std::size_t> {
protected:
    Case case_ = cases()[GetParam()];
};

TEST_P(CodecTest, GivesBackTheSameBytes) {
    const auto again = case_.recode(case_.blob);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(*again, case_.blob);
}

TEST_P(CodecTest, NamesKindAndVersionFirst) {
    EXPECT_EQ(case_.blob.substr(0, 4), case_.kind.mark);
    EXPECT_EQ(case_.blob[4], case_.kind.version);
    EXPECT_EQ(case_.blob.substr(5, 3), std::string(3, '\0'));
}

TEST_P(CodecTest, RefusesEveryTruncation) {
    for (std::size_t length = 0; length < case_.blob.size(); ++length) {
        const auto decoded = case_.recode(std::string_view(case_.blob).substr(0, length));
        ASSERT_FALSE(decoded) << length;
        EXPECT_EQ(decoded.error().code, ErrorCode::kIndexCorrupt) << length;
    }
}

TEST_P(CodecTest, RefusesEveryFlippedBit) {
    for (std::size_t at = 0; at < case_.blob.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = case_.blob;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            const auto decoded = case_.recode(damaged);
            ASSERT_FALSE(decoded) << at << " bit " << bit;
            EXPECT_EQ(decoded.error().code, ErrorCode::kIndexCorrupt);
        }
    }
}

TEST_P(CodecTest, SurvivesLiesUnderARightChecksum) {
    const std::size_t end = case_.blob.size() - kBlobTrailerSize;
    for (std::size_t at = 0; at < end; ++at) {
        for (const int value : {0x00, 0x01, 0x7F, 0x80, 0xFF}) {
            std::string changed = case_.blob;
            changed[at] = static_cast<char>(value);
            changed = with_checksum(changed);
            const auto decoded = case_.recode(changed);
            // Either refused, or taken for exactly what it says; packed bytes may say it otherwise.
            if (decoded) {
                EXPECT_EQ(*decoded, case_.packed ? *case_.recode(*decoded) : changed) << at;
            } else {
                const ErrorCode code = decoded.error().code;
                EXPECT_TRUE(code == ErrorCode::kIndexCorrupt ||
                            (at == 4 && code == ErrorCode::kIndexNewer));
            }
        }
    }
}

TEST_P(CodecTest, RefusesBytesLeftOverOrMissingUnderARightChecksum) {
    if (case_.name == "thumbnail") GTEST_SKIP() << "a picture's length is its own";
    const std::string padding(kBlobTrailerSize, '\0');
    const std::size_t end = case_.blob.size() - kBlobTrailerSize;
    EXPECT_FALSE(case_.recode(with_checksum(case_.blob.substr(0, end) + "x" + padding)));
    for (std::size_t length = kBlobHeaderSize; length < end; ++length) {
        EXPECT_FALSE(case_.recode(with_checksum(case_.blob.substr(0, length) + padding))) << length;
    }
}

TEST_P(CodecTest, RefusesALaterVersionAsNewer) {
    std::string later = case_.blob;
    later[4] = static_cast<char>(case_.kind.version + 1);
    const auto decoded = case_.recode(with_checksum(later));
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.error().code, ErrorCode::kIndexNewer);
}

/// A branch between two nodes with `samples` samples, rounded or not.
matching::SkeletonDescriptor one_branch(std::size_t samples, std::size_t digits, bool rounded) {
    matching::SkeletonDescriptor descriptor;
    descriptor.nodes.resize(2);
    descriptor.nodes[0] = {{0.25F, -0.0F, 1.0F}, 0.5F, 0.5F};
    descriptor.nodes[1] = {{1.25F, 2.0F, -1.0F}, 0.125F, 0.5F};
    matching::SkeletonDescriptor::Branch branch;
    branch.a = 0;
    branch.b = 1;
    branch.length = 3.0F;
    for (std::size_t i = 0; i < digits; ++i) {
        branch.chain_code += static_cast<char>('0' + i * i % 5);
    }
    for (std::size_t i = 0; i < samples; ++i) {
        const float unit = rounded ? matching::kPointUnit : 0.1F * matching::kPointUnit;
        for (const float multiple : {-32768.0F, 32767.0F, static_cast<float>(i) - 7.0F}) {
            branch.points.push_back(unit * multiple);
        }
        branch.radii.push_back(matching::kRadiusUnit * static_cast<float>(65535 - i));
    }
    descriptor.branches.push_back(branch);
    return descriptor;
}

TEST(Codec, PacksRoundedSamplesAndGivesThemBackBitByBit) {
    for (const std::size_t digits : {0U, 1U, 2U, 3U, 4U, 200U, 70'000U}) {
        for (const std::size_t samples : {2U, 3U, 40U}) {
            for (const bool rounded : {true, false}) {
                const matching::SkeletonDescriptor descriptor =
                    one_branch(samples, digits, rounded);
                const std::string blob = encode_descriptor(descriptor);
                const auto read = decode_descriptor(blob);
                ASSERT_TRUE(read) << read.error().message;
                EXPECT_EQ(test::earlier_descriptor(*read, 2),
                          test::earlier_descriptor(descriptor, 2));
                EXPECT_LE(blob.size(), 100 + (rounded ? 8 : 16) * samples + digits / 3 + 1);
            }
        }
    }
}

TEST(Codec, LeavesSamplesThatAreNotRoundedAsTheyAre) {
    const auto comes_back = [](const matching::SkeletonDescriptor& descriptor) {
        const auto read = decode_descriptor(encode_descriptor(descriptor));
        return read &&
               test::earlier_descriptor(*read, 2) == test::earlier_descriptor(descriptor, 2);
    };
    for (const float odd : {-0.0F, 8.0F, -8.1F, 1e30F, 0.5F * matching::kPointUnit}) {
        matching::SkeletonDescriptor descriptor = one_branch(3, 5, true);
        descriptor.branches[0].points[4] = odd;
        EXPECT_TRUE(comes_back(descriptor)) << odd;
    }
    for (const float odd : {-matching::kRadiusUnit, 1.0F, 0.5F * matching::kRadiusUnit}) {
        matching::SkeletonDescriptor descriptor = one_branch(3, 5, true);
        descriptor.branches[0].radii[1] = odd;
        EXPECT_TRUE(comes_back(descriptor)) << odd;
    }
}

TEST(Codec, RefusesPackedDigitsThatStandForNone) {
    const std::string blob = encode_descriptor(one_branch(2, 2, true));
    std::string payload = blob.substr(kBlobHeaderSize, blob.size() - 16);
    // The last bytes are the digits, the number of samples and two rounded samples.
    char& digits = payload[payload.size() - 3 - 2 * 8];
    ASSERT_TRUE(decode_descriptor(seal_blob(kDescriptorBlob, payload)));
    for (const int byte : {125, 255, 1}) {  // 1: a third digit where there are two
        digits = static_cast<char>(byte);
        EXPECT_FALSE(decode_descriptor(seal_blob(kDescriptorBlob, payload))) << byte;
    }
}

TEST(Codec, GivesBackSegmentsOfAnyNumberOfParts) {
    for (const std::uint32_t count : {1U, 2U, 255U, 256U, 257U, 1000U}) {
        ModelSegments segments;
        for (std::uint32_t p = 0; p < count; ++p) {
            decomposition::Decomposition::Part part{
                p % 3 + 1, 0.1 * p, static_cast<std::int32_t>(p) - 1, {}};
            if (p > 0) part.neighbors.push_back(p - 1);
            if (p + 1 < count) part.neighbors.push_back(p + 1);
            segments.parts.push_back(part);
            segments.labels.insert(segments.labels.end(), part.triangles, p);
        }
        const auto read = decode_segments(encode_segments(segments));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->labels, segments.labels);
        ASSERT_EQ(read->parts.size(), count);
        for (std::uint32_t p = 0; p < count; ++p) {
            EXPECT_EQ(read->parts[p].triangles, segments.parts[p].triangles);
            EXPECT_EQ(read->parts[p].area, segments.parts[p].area);
            EXPECT_EQ(read->parts[p].branch, segments.parts[p].branch);
            EXPECT_EQ(read->parts[p].neighbors, segments.parts[p].neighbors);
        }
    }
}

TEST(Codec, RefusesFeaturesThatCannotBe) {
    const registration::WholeFeatures sound = test::sample_model(4, "/x").features;
    const auto read = decode_features(encode_features(sound));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->area, sound.area);
    EXPECT_EQ(read->features.points, sound.features.points);
    EXPECT_EQ(read->features.normals, sound.features.normals);
    EXPECT_EQ(read->features.at(1, 2).values, sound.features.at(1, 2).values);
    const auto refused = [&sound](const auto& change) {
        registration::WholeFeatures changed = sound;
        change(changed);
        const auto decoded = decode_features(encode_features(changed));
        return !decoded && decoded.error().code == ErrorCode::kIndexCorrupt;
    };
    EXPECT_TRUE(refused([](auto& f) { f.area = -1.0; }));
    EXPECT_TRUE(refused([](auto& f) { f.features.points[1].x() = std::nan(""); }));
    EXPECT_TRUE(refused([](auto& f) { f.features.radii[1] = 2.0; })) << "out of order";
    EXPECT_TRUE(refused([](auto& f) { f.features.radii[0] = 0.0; }));
    EXPECT_TRUE(refused([](auto& f) { f.features.features.pop_back(); })) << "one too few";
}

TEST(Codec, RefusesSegmentsThatCannotBe) {
    const ModelSegments sound = *test::sample_model(4, "/x").segments;
    ASSERT_TRUE(decode_segments(encode_segments(sound)));
    const auto refused = [&sound](const std::function<void(ModelSegments&)>& change) {
        ModelSegments changed = sound;
        change(changed);
        const auto read = decode_segments(encode_segments(changed));
        return !read && read.error().code == ErrorCode::kIndexCorrupt;
    };
    EXPECT_TRUE(refused([](auto& s) { s.labels[1] = 2; })) << "a label that is no part";
    EXPECT_TRUE(refused([](auto& s) { s.labels[1] = 0; })) << "a part without a triangle";
    EXPECT_TRUE(refused([](auto& s) { s.parts[0].area = -1.0; }));
    EXPECT_TRUE(refused([](auto& s) { s.parts[0].area = std::nan(""); }));
    EXPECT_TRUE(refused([](auto& s) { s.parts[0].branch = -2; }));
    EXPECT_TRUE(refused([](auto& s) { s.parts[0].neighbors = {2}; })) << "no such part";
    EXPECT_TRUE(refused([](auto& s) { s.parts[0].neighbors = {0}; })) << "itself";
    EXPECT_TRUE(refused([](auto& s) { s.parts[0].neighbors = {1, 1}; })) << "twice";
}

TEST_P(CodecTest, RefusesEveryOtherKind) {
    for (const Case& other : cases()) {
        if (other.name == case_.name) continue;
        EXPECT_FALSE(case_.recode(other.blob)) << other.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Blobs, CodecTest, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& each) { return cases()[each.param].name; });

TEST(Codec, KeepsFloatsBitByBit) {
    const std::vector<float> odd = {-0.0F, std::numeric_limits<float>::denorm_min(),
                                    std::numeric_limits<float>::max(), 0.1F};
    const auto decoded = decode_signature(encode_signature(odd));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(std::memcmp(decoded->data(), odd.data(), odd.size() * sizeof(float)), 0);
}

TEST(Codec, RefusesNumbersThatAreNotFinite) {
    EXPECT_FALSE(decode_signature(encode_signature({1.0F, std::nanf("")})));
    NewModel model = test::sample_model(1, "");
    model.skeleton.nodes[0].radius = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(decode_skeleton(encode_skeleton(model.skeleton)));
    model.descriptor.skeleton.branches[0].points[0] = std::nanf("");
    EXPECT_FALSE(decode_descriptor(encode_descriptor(model.descriptor.skeleton)));
    model.preview.positions[0] = std::nanf("");
    EXPECT_FALSE(decode_preview(encode_preview(model.preview)));
}

TEST(Codec, RefusesIndicesOutOfRange) {
    NewModel model = test::sample_model(1, "");
    model.skeleton.branches[0].b = static_cast<std::uint32_t>(model.skeleton.nodes.size());
    EXPECT_FALSE(decode_skeleton(encode_skeleton(model.skeleton)));
    model.descriptor.skeleton.branches[0].a = 1000;
    EXPECT_FALSE(decode_descriptor(encode_descriptor(model.descriptor.skeleton)));
    model.preview.triangles[2] = 3;
    EXPECT_FALSE(decode_preview(encode_preview(model.preview)));
}

TEST(Codec, KeepsTheColoursOfPreviewsWhateverTheyAreOf) {
    using Of = PreviewColours::Of;
    PreviewMesh mesh = test::sample_model(1, "").preview;
    const std::size_t triangles = mesh.triangles.size() / 3;
    const std::size_t vertices = mesh.positions.size() / 3;
    for (const auto& [of, count] : {std::pair(Of::kNothing, std::size_t{0}),
                                    {Of::kModel, std::size_t{1}},
                                    {Of::kVertices, vertices},
                                    {Of::kTriangles, triangles},
                                    {Of::kCorners, 3 * triangles}}) {
        mesh.colours = {of, {}};
        for (std::size_t i = 0; i < 3 * count; ++i) {
            mesh.colours.bytes.push_back(static_cast<std::uint8_t>(17 * i + 3));
        }
        const auto decoded = decode_preview(encode_preview(mesh));
        ASSERT_TRUE(decoded) << decoded.error().message;
        EXPECT_EQ(decoded->colours, mesh.colours);
        mesh.colours.bytes.push_back(1);
        EXPECT_FALSE(decode_preview(encode_preview(mesh)));
    }
    mesh.colours = {static_cast<Of>(5), {}};
    EXPECT_FALSE(decode_preview(encode_preview(mesh)));
}

/// A wave of vertices on a grid of cells, whose positions are multiples of 2^exponent.
PreviewMesh wave(int exponent) {
    constexpr std::uint32_t kSide = 30;
    PreviewMesh mesh;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const double height = std::round(900.0 * std::sin(0.2 * x + 0.1 * y));
            for (const double multiple : {1000.0 * x - 15'000.0, 15'000.0 - 1000.0 * y, height}) {
                mesh.positions.push_back(static_cast<float>(std::ldexp(multiple, exponent)));
            }
            if (x == 0 || y == 0) continue;
            const std::uint32_t at = y * kSide + x;
            for (const std::uint32_t corner :
                 {at, at - 1, at - kSide, at - 1, at - kSide - 1, at - kSide}) {
                mesh.triangles.push_back(corner);
            }
        }
    }
    return mesh;
}

TEST(Codec, WritesPreviewsOnAGridInAThirdOfTheBytesAndGivesThemBackBitByBit) {
    for (const int exponent : {-140, -20, 0, 3, 100}) {
        const PreviewMesh mesh = wave(exponent);
        const std::string blob = encode_preview(mesh);
        EXPECT_LT(blob.size(), test::earlier_preview(mesh, 3).size() / 3);
        const auto read = decode_preview(blob);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->positions, mesh.positions);
        EXPECT_EQ(read->triangles, mesh.triangles);
    }
    // Off the grid by the last bit, beyond sixteen bits, and a zero with a sign.
    for (const float odd : {1.0F + 0x1p-23F, 40'000.0F, -0.0F}) {
        PreviewMesh mesh = wave(0);
        mesh.positions[1] = odd;
        const auto read = decode_preview(encode_preview(mesh));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(std::memcmp(read->positions.data(), mesh.positions.data(),
                              sizeof(float) * mesh.positions.size()),
                  0);
    }
}

TEST(Codec, WritesRoundedSkeletonsInFewerBytesAndGivesThemBackBitByBit) {
    const skeleton::SkeletonGraph graph = test::sample_model(4, "/x").skeleton;
    const skeleton::SkeletonGraph rounded = round_skeleton(graph);
    for (std::size_t b = 0; b < graph.branches.size(); ++b) {
        for (std::size_t i = 0; i < graph.branches[b].points.size(); ++i) {
            const Vec3& point = graph.branches[b].points[i];
            EXPECT_LT((rounded.branches[b].points[i] - point).cwiseAbs().maxCoeff(), 4e-6);
        }
    }
    EXPECT_EQ(encode_skeleton(round_skeleton(rounded)), encode_skeleton(rounded));
    EXPECT_LT(encode_skeleton(rounded).size(), 2 * encode_skeleton(graph).size() / 3);
    const auto read = decode_skeleton(encode_skeleton(rounded));
    ASSERT_TRUE(read) << read.error().message;
    for (std::size_t b = 0; b < graph.branches.size(); ++b) {
        EXPECT_EQ(read->branches[b].points, rounded.branches[b].points);
        EXPECT_EQ(read->branches[b].radii, rounded.branches[b].radii);
    }
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        EXPECT_EQ(read->nodes[n].position, rounded.nodes[n].position);
        EXPECT_EQ(read->nodes[n].degree, rounded.nodes[n].degree);
    }
}

TEST(Codec, RefusesPackedBytesThatClaimToBeTooMany) {
    const std::string packed = pack_bytes(std::string(50'000, 'a') + "b");
    ASSERT_TRUE(unpack_bytes(packed));
    for (const std::uint32_t claimed : {0U, 50'000U, 50'002U, 0xFFFFFFFFU}) {
        ByteWriter liar;
        liar.put(std::uint8_t{1});
        liar.put(claimed);
        liar.put_raw(std::string_view(packed).substr(5));
        EXPECT_FALSE(unpack_bytes(liar.bytes())) << claimed;
    }
    EXPECT_FALSE(unpack_bytes(""));
    EXPECT_FALSE(unpack_bytes("\x02whatever"));
}

TEST(Codec, PacksBytesOfAnyKind) {
    for (const std::size_t size : {0U, 1U, 100U, 1'000'000U}) {
        std::string noise(size, '\0');
        EXPECT_EQ(unpack_bytes(pack_bytes(noise)), noise) << "all alike";
        std::uint32_t state = 1;
        for (char& byte : noise)
            byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
        EXPECT_EQ(unpack_bytes(pack_bytes(noise)), noise);
        EXPECT_LE(pack_bytes(noise).size(), size + 1);
    }
}

TEST(Codec, KeepsPreviewsWithManyVertices) {
    PreviewMesh mesh;
    mesh.origin = {5e5, -5.1e6, 0.125};
    mesh.positions.assign(3 * 70'000, 1.5F);
    mesh.triangles = {0, 69'999, 5};
    const auto decoded = decode_preview(encode_preview(mesh));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->triangles, mesh.triangles);
    EXPECT_EQ(decoded->positions, mesh.positions);
    EXPECT_EQ(decoded->origin, mesh.origin);
}

TEST(Codec, KeepsWarnings) {
    const std::vector<mesh::MeshWarning> warnings = {{"a", 3, "x \"y\" \n"}, {"b", 0, ""}};
    const auto decoded = decode_warnings(encode_warnings(warnings));
    ASSERT_TRUE(decoded);
    ASSERT_EQ(decoded->size(), 2U);
    EXPECT_EQ((*decoded)[0].code, "a");
    EXPECT_EQ((*decoded)[0].count, 3U);
    EXPECT_EQ((*decoded)[0].message, "x \"y\" \n");
}

TEST(Codec, RefusesWarningsOfAnotherShape) {
    for (const char* text : {"", "{}", "[1]", "[{}]", "[{\"code\":1,\"count\":1,\"message\":\"\"}]",
                             "[{\"code\":\"a\",\"count\":-1,\"message\":\"\"}]", "[", "[[[["}) {
        const auto decoded = decode_warnings(text);
        ASSERT_FALSE(decoded) << text;
        EXPECT_EQ(decoded.error().code, ErrorCode::kIndexCorrupt);
    }
}

TEST(ContentHash, IsThePublishedValue) {
    // XXH3-128 of nothing with seed 0, from the algorithm's test vectors.
    EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f");
    EXPECT_NE(content_hash("a"), content_hash("b"));
    EXPECT_TRUE(is_content_hash(content_hash("a")));
    EXPECT_FALSE(is_content_hash("99AA06D3014798D86001C324468D497F"));
    EXPECT_FALSE(is_content_hash("99aa"));
}

}  // namespace
}  // namespace ossuary::index
