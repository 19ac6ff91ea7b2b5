#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "engine/voxel/npy.h"
#include "engine/voxel/volume.h"
#include "engine/voxel/volume_values.h"
#include "tests/support/packed.h"
#include "tests/support/shapes.h"

namespace ossuary::test {
namespace {

/// All values, x fastest.
std::vector<double> values_of(const voxel::Volume& volume) {
    std::vector<double> values(volume.voxel_count());
    const Vec3i size = volume.size;
    voxel::visit_values(volume, {}, [&](const Vec3i& at, double value) {
        values[static_cast<std::size_t>((at.z() * size.y() + at.y()) * size.x() + at.x())] = value;
    });
    return values;
}

void expect_refused(const std::string& bytes, ErrorCode code, const std::string& says) {
    const auto read = voxel::read_volume(bytes, "file");
    ASSERT_FALSE(read) << says;
    EXPECT_EQ(read.error().code, code) << read.error().message;
    EXPECT_NE(read.error().message.find(says), std::string::npos) << read.error().message;
    EXPECT_EQ(read.error().message.rfind("file", 0), 0U) << read.error().message;
}

/// Reads every beginning of the bytes and bytes with one changed; none may do worse than fail.
void expect_survives(const std::string& bytes) {
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const std::string cut = bytes.substr(0, length);
        const auto read = voxel::read_volume(cut, "file");
        if (!read) {
            ASSERT_FALSE(read.error().message.empty());
        }
    }
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (const char change : {'\x01', '\x10', '\x80', '\x7f'}) {
            std::string damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ change);
            const auto read = voxel::read_volume(damaged, "file");
            if (read) {
                ASSERT_EQ(values_of(*read).size(), read->voxel_count());
            }
        }
    }
}

template <typename T>
std::string bytes_of(const std::vector<T>& numbers, bool reversed = false) {
    std::string bytes;
    for (const T& number : numbers) {
        char raw[sizeof(T)];
        std::memcpy(raw, &number, sizeof(T));
        if (reversed) std::reverse(raw, raw + sizeof(T));
        bytes.append(raw, sizeof(T));
    }
    return bytes;
}

// ---- NRRD ----

std::string nrrd(const std::string& fields, const std::string& data) {
    return "NRRD0004\n# a comment\n" + fields + "\n" + data;
}
const std::string kSmall = "type: short\ndimension: 3\nsizes: 2 1 3\n";
const std::vector<std::int16_t> kSix = {1, -2, 300, 4, 5, 6};
const std::vector<double> kSixReal = {1, -2, 300, 4, 5, 6};

TEST(ReadNrrd, TakesEachEncodingAndByteOrder) {
    const std::string files[] = {
        nrrd(kSmall + "encoding: raw\nendian: little\n", bytes_of(kSix)),
        nrrd(kSmall + "encoding: raw\nendian: big\n", bytes_of(kSix, true)),
        nrrd(kSmall + "encoding: ascii\n", "1 -2\n300 4 5\n6\n"),
        nrrd(kSmall + "encoding: gzip\nendian: little\n", gzipped(bytes_of(kSix))),
        nrrd(kSmall + "encoding: raw\nendian: little\nbyte skip: 3\n", "xyz" + bytes_of(kSix)),
        nrrd(kSmall + "encoding: raw\nendian: little\nbyte skip: -1\n", "xyzw" + bytes_of(kSix)),
        nrrd(kSmall + "encoding: raw\nendian: little\nline skip: 2\n", "a\nb\n" + bytes_of(kSix)),
        nrrd(kSmall + "key:=value: of the user\nencoding: raw\nendian: little\n", bytes_of(kSix)),
    };
    for (const std::string& file : files) {
        const auto read = voxel::read_volume(file, "file");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->size, Vec3i(2, 1, 3));
        EXPECT_EQ(values_of(*read), kSixReal);
    }
}

TEST(ReadNrrd, TakesEveryType) {
    const auto check = [](const std::string& type, const std::string& data, double expected) {
        const std::string file =
            nrrd("type: " + type + "\ndimension: 3\nsizes: 1 1 1\nencoding: raw\nendian: little\n",
                 data);
        const auto read = voxel::read_volume(file, "file");
        ASSERT_TRUE(read) << type << ": " << read.error().message;
        EXPECT_EQ(values_of(*read), std::vector<double>{expected}) << type;
    };
    check("signed char", bytes_of<std::int8_t>({-7}), -7);
    check("unsigned char", bytes_of<std::uint8_t>({200}), 200);
    check("uint16", bytes_of<std::uint16_t>({60'000}), 60'000);
    check("int", bytes_of<std::int32_t>({-70'000}), -70'000);
    check("unsigned int", bytes_of<std::uint32_t>({4'000'000'000U}), 4e9);
    check("long long", bytes_of<std::int64_t>({-5}), -5);
    check("uint64_t", bytes_of<std::uint64_t>({5}), 5);
    check("float", bytes_of<float>({0.5F}), 0.5);
    check("Double", bytes_of<double>({1e-300}), 1e-300);
}

TEST(ReadNrrd, KnowsWhereVoxelsLie) {
    const std::string spaced_file =
        nrrd(kSmall + "spacings: 0.5 NaN 2\nencoding: ascii\n", "1 2 3 4 5 6");
    const auto spaced = voxel::read_volume(spaced_file, "file");
    ASSERT_TRUE(spaced) << spaced.error().message;
    EXPECT_EQ(spaced->axes, Mat3(Vec3(0.5, 1, 2).asDiagonal()));
    const std::string directed_file = nrrd(
        "type: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: 1 2 1 3\n"
        "space directions: none (0,2,0) (-1, 0, 0) (0,0,1.5)\nspace origin: (10,20,-3e1)\n"
        "space units: \"mm\" \"mm\" \"mm\"\nencoding: ascii\n",
        "1 2 3 4 5 6");
    const auto directed = voxel::read_volume(directed_file, "file");
    ASSERT_TRUE(directed) << directed.error().message;
    EXPECT_EQ(directed->size, Vec3i(2, 1, 3));
    EXPECT_EQ(directed->axes.col(0), Vec3(0, 2, 0));
    EXPECT_EQ(directed->axes.col(1), Vec3(-1, 0, 0));
    EXPECT_EQ(directed->axes.col(2), Vec3(0, 0, 1.5));
    EXPECT_EQ(directed->origin, Vec3(10, 20, -30));
    EXPECT_EQ(directed->unit, "mm");
}

TEST(ReadNrrd, RefusesWithLineAndCode) {
    using enum ErrorCode;
    const std::string raw = "encoding: raw\nendian: little\n";
    expect_refused(nrrd(kSmall + "data file: values.raw\n" + raw, ""), kVolumeDetached,
                   "line 6: expected the values in the same file, found them in 'values.raw'");
    expect_refused(nrrd(kSmall + "datafile: LIST\n" + raw, ""), kVolumeDetached, "'LIST'");
    expect_refused("NRRD0009\n\n", kNrrdInvalid, "line 1");
    expect_refused(nrrd(kSmall + "encoding: bzip2\n", ""), kNrrdInvalid, "'bzip2'");
    expect_refused(nrrd("type: block\n", ""), kNrrdInvalid, "line 3: type");
    expect_refused(nrrd(kSmall + "encoding: raw\n", bytes_of(kSix)), kNrrdInvalid, "endian");
    expect_refused(nrrd(kSmall + raw, bytes_of(kSix).substr(1)), kNrrdInvalid,
                   "expected 12 bytes for 2 x 1 x 3 voxels, found 11");
    expect_refused(nrrd(kSmall + "encoding: txt\n", "1 2 3 4 5"), kNrrdInvalid,
                   "expected 6 numbers, the file ends after 5");
    expect_refused(nrrd(kSmall + "encoding: txt\n", "1 2 3 4 5 six"), kNrrdInvalid, "'six'");
    expect_refused(nrrd("type: uchar\ndimension: 3\nsizes: 2 2\n" + raw, ""), kNrrdInvalid,
                   "expected 3 sizes, found 2");
    expect_refused(nrrd("type: uchar\ndimension: 2\nsizes: 2 2\n" + raw, "1234"), kNrrdInvalid,
                   "three axes");
    expect_refused(nrrd("type: uchar\ndimension: 4\nsizes: 2 2 2 2\n" + raw, "1234"), kNrrdInvalid,
                   "three axes");
    expect_refused(nrrd("type: uchar\ndimension: 3\nsizes: 0 2 2\n" + raw, ""), kNrrdInvalid,
                   "line 5: sizes");
    expect_refused(nrrd("type: uchar\ndimension: 3\nsizes: 5000 2 2\n" + raw, ""), kVolumeTooLarge,
                   "5000 x 2 x 2");
    expect_refused(nrrd("type: uchar\ndimension: 3\nsizes: 4000 4000 4000\n" + raw, ""),
                   kVolumeTooLarge, "4000");
    expect_refused(nrrd(kSmall + "space directions: (1,0,0) (2,0,0) (0,0,1)\n" + raw, ""),
                   kNrrdInvalid, "span space");
    expect_refused(nrrd(kSmall + "encoding: gzip\nendian: little\n", "no gzip"), kGzipInvalid,
                   "gzip");
    expect_refused("NRRD0004\ntype: uchar\n", kNrrdInvalid, "empty line");
    expect_refused(nrrd("no colon\n", ""), kNrrdInvalid, "line 3: expected a field");
}

TEST(ReadNrrd, SurvivesCutsAndDamage) {
    expect_survives(nrrd(kSmall + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: "
                                  "(0,0,0)\nencoding: raw\nendian: little\n",
                         bytes_of(kSix)));
    expect_survives(nrrd(kSmall + "encoding: gzip\nendian: big\n", gzipped(bytes_of(kSix))));
}

// ---- NIfTI ----

struct Nifti {
    std::string bytes = std::string(352, '\0');
    bool reversed = false;

    template <typename T>
    Nifti& put(std::size_t at, const std::vector<T>& numbers) {
        const std::string raw = bytes_of(numbers, reversed);
        bytes.replace(at, raw.size(), raw);
        return *this;
    }
};

/// A header for six voxels, 2 x 1 x 3, of a type and the bytes of one.
Nifti nifti(std::int16_t type, bool reversed = false) {
    Nifti file;
    file.reversed = reversed;
    file.put<std::int32_t>(0, {348});
    file.put<std::int16_t>(40, {3, 2, 1, 3, 1, 1, 1, 1});
    file.put<std::int16_t>(70, {type});
    file.put<float>(76, {1, 0.5F, 1, 2});
    file.put<float>(108, {352});
    file.bytes.replace(344, 4, std::string("n+1\0", 4));
    return file;
}

TEST(ReadNifti, TakesBothByteOrdersAndSlopes) {
    for (const bool reversed : {false, true}) {
        Nifti file = nifti(4, reversed);
        file.bytes += bytes_of(kSix, reversed);
        const auto read = voxel::read_volume(file.bytes, "file");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(values_of(*read), kSixReal);
        EXPECT_EQ(read->axes, Mat3(Vec3(0.5, 1, 2).asDiagonal()));
        EXPECT_EQ(read->unit, "");
        file.put<float>(112, {2, 0.5F});
        file.bytes[123] = 2;
        const auto scaled = voxel::read_volume(file.bytes, "file");
        ASSERT_TRUE(scaled);
        EXPECT_EQ(values_of(*scaled)[2], 600.5);
        EXPECT_EQ(scaled->unit, "mm");
    }
}

TEST(ReadNifti, KnowsWhereVoxelsLie) {
    Nifti file = nifti(2);
    file.bytes += "123456";
    file.put<std::int16_t>(252, {1});  // qform: a quarter turn about z
    const float half = std::sqrt(0.5F);
    file.put<float>(256, {0, 0, half, 7, 8, 9});
    const auto turned = voxel::read_volume(file.bytes, "file");
    ASSERT_TRUE(turned) << turned.error().message;
    EXPECT_LT((turned->axes.col(0) - Vec3(0, 0.5, 0)).norm(), 1e-6);
    EXPECT_LT((turned->axes.col(1) - Vec3(-1, 0, 0)).norm(), 1e-6);
    EXPECT_EQ(turned->origin, Vec3(7, 8, 9));
    file.put<float>(76, {-1});
    EXPECT_LT((voxel::read_volume(file.bytes, "file")->axes.col(2) - Vec3(0, 0, -2)).norm(), 1e-6);
    file.put<std::int16_t>(254, {1});  // sform goes before
    file.put<float>(280, {0, 3, 0, 1, 4, 0, 0, 2, 0, 0, 5, 3});
    const auto placed = voxel::read_volume(file.bytes, "file");
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->axes.col(0), Vec3(0, 4, 0));
    EXPECT_EQ(placed->axes.col(1), Vec3(3, 0, 0));
    EXPECT_EQ(placed->axes.col(2), Vec3(0, 0, 5));
    EXPECT_EQ(placed->origin, Vec3(1, 2, 3));
}

TEST(ReadNifti, RefusesWithPlaceAndCode) {
    using enum ErrorCode;
    Nifti file = nifti(2);
    expect_refused(file.bytes + "12345", kNiftiInvalid, "byte 352: expected 6 bytes");
    const auto changed = [](auto change) {
        Nifti other = nifti(2);
        other.bytes += "123456";
        change(other);
        return other.bytes;
    };
    expect_refused(changed([](Nifti& n) { n.put<std::int16_t>(40, {2}); }), kNiftiInvalid,
                   "byte 40");
    expect_refused(changed([](Nifti& n) {
                       n.put<std::int16_t>(40, {4, 2, 1, 3, 2});
                   }),
                   kNiftiInvalid, "axis 4: expected 1 sample, found 2");
    expect_refused(changed([](Nifti& n) { n.put<std::int16_t>(42, {-2}); }), kNiftiInvalid,
                   "byte 42");
    expect_refused(changed([](Nifti& n) { n.put<std::int16_t>(70, {128}); }), kNiftiInvalid,
                   "data type 128");
    expect_refused(changed([](Nifti& n) { n.put<float>(108, {1e9F}); }), kNiftiInvalid, "byte 108");
    expect_refused(changed([](Nifti& n) {
                       n.put<float>(80, {0, 0, 0});
                   }),
                   kNiftiInvalid, "byte 76");
    expect_refused(changed([](Nifti& n) { n.bytes.replace(344, 3, "ni1"); }), kNiftiInvalid,
                   "a header alone");
    expect_refused(changed([](Nifti& n) { n.put<std::int16_t>(42, {5000}); }), kVolumeTooLarge,
                   "5000");
    std::string second = changed([](Nifti& n) { n.put<std::int32_t>(0, {540}); });
    second.replace(4, 4, std::string("n+2\0", 4));
    expect_refused(second, kFormatUnsupported, "NIfTI-2");
}

TEST(ReadNifti, SurvivesCutsAndDamage) {
    Nifti file = nifti(4);
    file.bytes += bytes_of(kSix);
    expect_survives(file.bytes);
}

// ---- binvox ----

std::string binvox(const std::string& runs, const std::string& dim = "2 2 2") {
    return "#binvox 1\ndim " + dim + "\ntranslate 1 2 3\nscale 4\ndata\n" + runs;
}

TEST(ReadBinvox, PutsRunsWhereTheyBelong) {
    // y fastest, then z, then x: voxels 0, 1 and 7 are set.
    const std::string file = binvox(std::string("\x01\x02\x00\x05\x01\x01", 6));
    const auto read = voxel::read_volume(file, "file");
    ASSERT_TRUE(read) << read.error().message;
    std::vector<Vec3> set;
    voxel::visit_values(*read, {}, [&](const Vec3i& voxel, double value) {
        if (value != 0) set.push_back(read->origin + read->axes * voxel.cast<double>());
    });
    ASSERT_EQ(set.size(), 3U);
    EXPECT_EQ(set[0], Vec3(2, 3, 4));
    EXPECT_EQ(set[1], Vec3(2, 5, 4));
    EXPECT_EQ(set[2], Vec3(4, 5, 6));
}

TEST(ReadBinvox, RefusesWithPlaceAndCode) {
    using enum ErrorCode;
    const std::string eight("\x01\x08", 2);
    const std::string whole = binvox(eight);
    EXPECT_TRUE(voxel::read_volume(whole, "file"));
    expect_refused(binvox(std::string("\x01\x07", 2)), kBinvoxInvalid,
                   "expected runs of 8 voxels, the file ends after 7");
    expect_refused(binvox(std::string("\x01\x09", 2)), kBinvoxInvalid, "at most 8");
    expect_refused(binvox(eight, "0 2 2"), kBinvoxInvalid, "line 2");
    expect_refused(binvox(eight, "2 two 2"), kBinvoxInvalid, "line 2");
    expect_refused(binvox(eight, "4096 4096 4096"), kVolumeTooLarge, "4096");
    expect_refused(binvox(eight, "600 600 600"), kBinvoxInvalid, "the file ends");
    expect_refused("#binvox 2\ndim 2 2 2\ndata\n" + eight, kBinvoxInvalid, "line 1");
    expect_refused("#binvox 1\ndata\n" + eight, kBinvoxInvalid, "expected dim before data");
    expect_refused("#binvox 1\ndim 2 2 2\nscale 0\ndata\n" + eight, kBinvoxInvalid, "scale");
    expect_refused("#binvox 1\ndim 2 2 2\ncolor 1\ndata\n" + eight, kBinvoxInvalid, "'color'");
    expect_refused("#binvox 1\ndim 2 2 2\n", kBinvoxInvalid, "ends with data");
}

TEST(ReadBinvox, SurvivesCutsAndDamage) {
    expect_survives(binvox(std::string("\x01\x02\x00\x05\x01\x01", 6)));
}

// ---- npy ----

TEST(ReadNpyVolume, TakesRealNumbersAndBothOrders) {
    const auto array = [](const std::string& descr, const std::string& order,
                          const std::string& values) {
        std::string header =
            "{'descr': '" + descr + "', 'fortran_order': " + order + ", 'shape': (2, 1, 3), }";
        header += std::string(117 - header.size(), ' ') + "\n";
        return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + values;
    };
    const std::string fortran_file = array("<i2", "True", bytes_of(kSix));
    const auto fortran = voxel::read_volume(fortran_file, "file");
    ASSERT_TRUE(fortran) << fortran.error().message;
    EXPECT_EQ(values_of(*fortran), kSixReal);
    const std::string c_order_file =
        array(">f4", "False", bytes_of<float>({1, 300, 5, -2, 4, 6}, true));
    const auto c_order = voxel::read_volume(c_order_file, "file");
    ASSERT_TRUE(c_order) << c_order.error().message;
    EXPECT_EQ(values_of(*c_order), kSixReal);
    expect_refused(array("<c8", "False", ""), ErrorCode::kNpyInvalid, "'<c8'");
    expect_survives(array("<i2", "False", bytes_of(kSix)));
}

TEST(ReadVolume, TellsFormatsByTheirFirstBytes) {
    EXPECT_FALSE(voxel::looks_like_volume("OFF\n"));
    EXPECT_FALSE(voxel::looks_like_volume(""));
    EXPECT_FALSE(voxel::looks_like_volume(std::string(400, '\0')));
    EXPECT_TRUE(voxel::looks_like_volume(nifti(2, true).bytes));
    EXPECT_TRUE(voxel::looks_like_volume(voxel::format_npy(cube(8).volume)));
    EXPECT_EQ(voxel::read_volume("OFF\n", "file").error().code, ErrorCode::kFormatUnknown);
}

}  // namespace
}  // namespace ossuary::test
