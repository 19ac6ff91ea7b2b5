#include "index/gltf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, 4);
    return word;
}

/// A unit box with its low corner here, two parts and two joints.
std::string box_glb(const Vec3& low) {
    const mesh::TriangleMesh mesh = test::box_mesh(low, low + Vec3(1, 1, 1));
    std::vector<std::uint32_t> labels(mesh.triangles.size(), 0);
    labels[3] = labels[5] = 1;
    decomposition::Rig rig;
    rig.joints = {{low + Vec3(0.5, 0.5, 0.5), -1, -1}, {low + Vec3(0.5, 0.5, 1.0), 0, 0}};
    rig.weights.assign(mesh.vertices.size(), {{1, 0, 0, 0}, {0.75F, 0.25F, 0.0F, 0.0F}});
    return to_glb(mesh, decomposition::dense_segmentation(labels), rig, "box");
}

TEST(Gltf, PositionsAreThoseAboutTheMiddleWhereverTheModelLies) {
    const Vec3 low(1e9, -2e9, 3e9);
    const std::string far = box_glb(low), near = box_glb({0, 0, 0});
    const auto parsed = [](const std::string& glb) {
        return nlohmann::json::parse(glb.substr(20, word_at(glb, 12)));
    };
    const auto far_away = parsed(far), at_zero = parsed(near);
    // The same bytes but for the one translation: nothing is lost.
    EXPECT_EQ(far.substr(20 + word_at(far, 12)), near.substr(20 + word_at(near, 12)));
    EXPECT_EQ(far_away["nodes"][3]["translation"],
              nlohmann::json::array({1e9 + 0.5, -2e9 + 0.5, 3e9 + 0.5}));
    EXPECT_EQ(at_zero["nodes"][3]["translation"], nlohmann::json::array({0.5, 0.5, 0.5}));
    EXPECT_EQ(at_zero["nodes"][3]["children"], nlohmann::json::array({0}));
    EXPECT_EQ(at_zero["scenes"][0]["nodes"], nlohmann::json::array({2, 3}));
    EXPECT_EQ(far_away["nodes"][0]["translation"], nlohmann::json::array({0.0, 0.0, 0.0}));
    EXPECT_EQ(at_zero["accessors"][0]["max"], nlohmann::json::array({0.5, 0.5, 0.5}));
}

TEST(Gltf, HoldsPartsJointsAndWeights) {
    const mesh::TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
    const std::string glb = box_glb({0, 0, 0});

    ASSERT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(word_at(glb, 8), glb.size());
    const std::size_t text_bytes = word_at(glb, 12);
    const auto document = nlohmann::json::parse(glb.substr(20, text_bytes));
    EXPECT_EQ(document["meshes"][0]["primitives"].size(), 2u);
    EXPECT_EQ(document["skins"][0]["joints"].size(), 2u);
    EXPECT_EQ(document["nodes"][0]["children"], nlohmann::json::array({1}));
    EXPECT_EQ(document["nodes"][1]["translation"], nlohmann::json::array({0.0, 0.0, 0.5}));
    // What readers go by; names are for people.
    EXPECT_FALSE(document["nodes"][0].contains("extras"));
    EXPECT_EQ(document["nodes"][1]["extras"], (nlohmann::json{{"branch", 0}}));
    EXPECT_EQ(document["materials"][1]["extras"], (nlohmann::json{{"part", 1}}));
    // Every accessor lies in the buffer, and the buffer ends the file.
    const std::size_t buffer = document["buffers"][0]["byteLength"];
    EXPECT_EQ(20 + text_bytes + 8 + buffer, glb.size());
    for (const auto& view : document["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                  buffer);
    }
    std::size_t indices = 0;
    for (const auto& primitive : document["meshes"][0]["primitives"]) {
        indices += document["accessors"][primitive["indices"].get<std::size_t>()]["count"]
                       .get<std::size_t>();
    }
    EXPECT_EQ(indices, 3 * mesh.triangles.size());
}

}  // namespace
}  // namespace ossuary::index
