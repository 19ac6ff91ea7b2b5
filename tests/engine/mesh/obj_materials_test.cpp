#include "engine/mesh/obj_materials.h"

#include <gtest/gtest.h>

#include "engine/mesh/read_obj.h"
#include "tests/engine/mesh/model_corpus.h"

namespace ossuary::mesh {
namespace {

using Names = std::vector<std::string>;

TEST(MaterialColours, AreTheDiffuseOnesOfALibrary) {
    const auto colours = read_material_colours(
        "# a library\r\nKd 1 1 1\r\nnewmtl  red paint \r\n\tKa 0 1 0\r\n\tKd 1.0 0 2.0\r\n"
        "map_Kd wood.png\r\nnewmtl grey\nKd .5\nnewmtl odd\nKd spectral a.rfl 1\nKd nan 0 0\n"
        "Kd 1 0\nnewmtl late\nKd 0 0 0\nKd 0 1 0");
    const MaterialColours expected = {{"", {255, 255, 255}},
                                      {"red paint", {255, 0, 255}},
                                      {"grey", {128, 128, 128}},
                                      {"late", {0, 255, 0}}};
    EXPECT_EQ(colours, expected);
    EXPECT_TRUE(read_material_colours("").empty());
}

TEST(MaterialLibraries, AreNamedByTheLinesOfAFile) {
    EXPECT_EQ(material_libraries("mtllib a.mtl"), Names{"a.mtl"});
    EXPECT_EQ(material_libraries("# mtllib a.mtl\nv 1 2 mtllib b\r\n\t mtllib\tsub\\c.mtl \r\n"
                                 "mtllib sub/c.mtl\rmtllibs d\nmtllib\nmtllib \nmtllib ./e.mtl"),
              (Names{"sub/c.mtl", "./e.mtl"}));
    EXPECT_EQ(material_libraries("mtllib my paints.mtl"),
              (Names{"my paints.mtl", "my", "paints.mtl"}));
    EXPECT_TRUE(material_libraries("").empty());
}

/// A square of two triangles between two triangles, in three materials.
constexpr std::string_view kStripes =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\n"
    "f 1 2 5\nusemtl one\nf 1 2 3 4\ng legs\nusemtl not there\nf 1 3 5\nusemtl one\nf 3 4 5\n";

std::string colours_of(std::string_view obj, const MaterialColours& colours) {
    auto read = read_obj(obj, "a.obj");
    EXPECT_TRUE(read);
    colour_by_materials(*read, colours);
    return test::colours_text(read->mesh);
}

TEST(MaterialColours, AreThoseOfTheTrianglesThatAreMadeOfThem) {
    EXPECT_EQ(colours_of(kStripes, {{"one", {255, 0, 0}}, {"two", {0, 0, 255}}}),
              "aaaaaa ff0000 ff0000 aaaaaa ff0000");
    EXPECT_EQ(colours_of(kStripes, {{"One", {255, 0, 0}}}), "none");
    EXPECT_EQ(colours_of(kStripes, {}), "none");
    EXPECT_EQ(colours_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3", {{"", {255, 0, 0}}}), "none");
}

TEST(MaterialColours, LeaveAModelAloneThatHasColoursOrIsWhite) {
    const std::string coloured = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nusemtl a\nf 1 2 3";
    EXPECT_EQ(colours_of(coloured, {{"a", {0, 0, 255}}}), "ff0000");
    const std::string plain = "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\nf 1 2 3";
    EXPECT_EQ(colours_of(plain, {{"a", {0, 0, 255}}}), "0000ff");
    EXPECT_EQ(colours_of(plain, {{"a", {255, 255, 255}}}), "none");
}

TEST(MaterialColours, AreKeptByFacesThatNameVerticesToCome) {
    EXPECT_EQ(colours_of("usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\n",
                         {{"a", {1, 2, 3}}, {"b", {4, 5, 6}}}),
              "010203 040506");
}

}  // namespace
}  // namespace ossuary::mesh
