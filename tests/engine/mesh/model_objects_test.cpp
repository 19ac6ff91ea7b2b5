// The objects that files tell apart.

#include "engine/mesh/model_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/mesh/measures.h"

namespace ossuary::mesh {
namespace {

using testing::ElementsAre;

/// Name, first triangle and number of triangles of each.
std::vector<std::string> objects_of(std::string_view bytes) {
    const auto read = read_mesh(bytes, "file");
    EXPECT_TRUE(read) << read.error().message;
    std::vector<std::string> told;
    for (const ModelObject& object : read->objects) {
        told.push_back(object.name + ":" + std::to_string(object.first_triangle) + "+" +
                       std::to_string(object.triangles));
    }
    return told;
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";

TEST(ModelObjects, OfObjAreItsObjectsAndElseItsGroups) {
    const std::string vertices = kSquare;
    EXPECT_THAT(objects_of(vertices + "o left #1\ng a\nf 1 2 3\ng b\nf 1 3 4\no right\n"
                                      "f 1 2 3 4\n"),
                ElementsAre("left #1:0+2", "right:2+2"));
    EXPECT_THAT(objects_of(vertices + "g a\nf 1 2 3\ng\nf 1 3 4\ng empty\ng  b c \nf 1 2 3 4\n"),
                ElementsAre("a:0+1", ":1+1", "b c:2+2"));
    EXPECT_THAT(objects_of(vertices + "f 1 2 3\no late\nf 1 2 5\n"),
                ElementsAre(":0+1", "late:1+1"));
    EXPECT_THAT(objects_of(vertices + "f 1 2 3\n"), ElementsAre(":0+1"));
    // Faces before their vertices.
    EXPECT_THAT(objects_of("o a\nf 1 2 3\no b\nf 1 2\nf 1 2 3 4\n" + vertices),
                ElementsAre("a:0+1", "b:1+2"));
}

TEST(ModelObjects, OfStlAreItsSolids) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\n";
    EXPECT_THAT(objects_of("solid a part\n" + facet + facet + "endsolid a part\nsolid\n" + facet +
                           "endsolid\nsolid none\nendsolid none\n"),
                ElementsAre("a part:0+2", ":2+1"));
}

TEST(ModelObjects, HaveNamesByWhichTheyCanBeAskedFor) {
    const std::vector<ModelObject> objects = {{"wheel"}, {"wheel"},    {""},     {"wheel (2)"},
                                              {"wheel"}, {"a\nb\x7f"}, {"\xe4"}, {""}};
    EXPECT_THAT(object_names(objects),
                ElementsAre("wheel", "wheel (2)", "object 3", "wheel (2) (2)", "wheel (3)", "ab",
                            "\xef\xbf\xbd", "object 8"));
}

TEST(ModelObjects, AreMeshesOfTheirOwn) {
    const auto read =
        read_mesh(std::string(kSquare) + "o a\nf 5 2 1\no b\nf 1 2 3 4\nf 3 4 5\n", "file");
    ASSERT_TRUE(read);
    ASSERT_EQ(read->objects.size(), 2U);
    const TriangleMesh first = object_mesh(read->mesh, read->objects[0]);
    EXPECT_EQ(first.vertices.size(), 3U);
    EXPECT_EQ(first.vertices[2], Vec3(0, 0, 1));
    EXPECT_EQ(first.triangles[0], (TriangleMesh::Triangle{2, 1, 0}));
    const TriangleMesh second = object_mesh(read->mesh, read->objects[1]);
    EXPECT_EQ(second.vertices.size(), 5U);
    EXPECT_EQ(second.face_count, 2U);
    EXPECT_THAT(second.face_of_triangle, ElementsAre(0, 0, 1));
    EXPECT_DOUBLE_EQ(measure(first).surface_area + measure(second).surface_area,
                     measure(read->mesh).surface_area);
}

}  // namespace
}  // namespace ossuary::mesh
