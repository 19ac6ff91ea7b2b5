#include "index/model_segments.h"
#include "index/preview.h"

#include <gtest/gtest.h>

#include "engine/decomposition/decompose.h"
#include "engine/mesh/decimate.h"
#include "engine/mesh/measures.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "index/describe_model.h"
#include "tests/index/sample_index.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

NewModel described(const fs::path& path) {
    const std::string bytes = test::read_file(path), name = path.string();
    auto model = describe_model({bytes, name}, {});
    EXPECT_TRUE(model) << model.error().message;
    return *std::move(model);
}

/// The share of the preview's area that each part has.
std::vector<double> shares_on_preview(const NewModel& model) {
    const mesh::TriangleMesh mesh = mesh_of(model.preview);
    std::vector<double> shares(model.segments->parts.size(), 0.0);
    double total = 0.0;
    for (std::size_t t = 0; t < model.segments->labels.size(); ++t) {
        const double area = mesh::triangle_area(mesh, t);
        shares[model.segments->labels[t]] += area;
        total += area;
    }
    for (double& share : shares) share /= total;
    return shares;
}

TEST(Preview, KeepsEveryVertexOfAModelFarFromTheFilesOrigin) {
    const auto text_at = [](const Vec3& place) {
        mesh::TriangleMesh mesh = test::icosphere_mesh({0, 0, 0}, 0.5);
        for (Vec3& vertex : mesh.vertices) vertex += place;
        return mesh::to_off(mesh);
    };
    // A place like that of a survey in a metric grid: floats there are half a unit apart.
    const Vec3 place(3.5e5, 5.8e6, 120);
    const std::string near = text_at({0, 0, 0}), far = text_at(place);
    const auto at_zero = describe_model({near, "near"}, {}),
               away = describe_model({far, "far"}, {});
    ASSERT_TRUE(at_zero && away);
    EXPECT_TRUE(away->preview.origin.isApprox(at_zero->preview.origin + place, 1e-12));
    ASSERT_EQ(away->preview.positions.size(), at_zero->preview.positions.size());
    EXPECT_EQ(away->preview.triangles, at_zero->preview.triangles);
    for (std::size_t i = 0; i < away->preview.positions.size(); ++i) {
        EXPECT_NEAR(away->preview.positions[i], at_zero->preview.positions[i], 1e-7);
    }
}

TEST(ModelSegments, AreThoseOfTheFile) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    // Machine parts that a preview is too coarse to be cut by, an armadillo, an ant, a chair.
    for (const char* name : {"325.off", "341.off", "281.off", "81.off", "101.off"}) {
        SCOPED_TRACE(name);
        const fs::path path = data / "princeton-segmentation" / "off" / name;
        const auto mesh = mesh::read_mesh(path);
        ASSERT_TRUE(mesh) << mesh.error().message;
        const auto whole = decomposition::decompose(mesh->mesh);
        ASSERT_TRUE(whole) << whole.error().message;
        const NewModel model = described(path);
        ASSERT_TRUE(model.segments);
        const auto& parts = model.segments->parts;
        ASSERT_EQ(parts.size(), whole->parts.size());
        const double area = mesh::measure(mesh->mesh).surface_area;
        const auto on_preview = shares_on_preview(model);
        std::size_t triangles = 0;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            EXPECT_EQ(parts[p].area, whole->parts[p].area) << p;
            EXPECT_EQ(parts[p].neighbors, whole->parts[p].neighbors) << p;
            EXPECT_NEAR(on_preview[p], whole->parts[p].area / area, 0.03) << p;
            EXPECT_GE(parts[p].triangles, 1U) << p;
            triangles += parts[p].triangles;
        }
        EXPECT_EQ(triangles * 3, model.preview.triangles.size());
    }
}

TEST(ModelSegments, NameBranchesOfTheStoredSkeleton) {
    const std::string off = mesh::to_off(test::capsule_tree_mesh());
    const auto model = describe_model({off, "tree"}, {});
    ASSERT_TRUE(model && model->segments);
    std::size_t named = 0;
    for (const auto& part : model->segments->parts) {
        EXPECT_LT(part.branch, static_cast<std::int32_t>(model->skeleton.branches.size()));
        if (part.branch >= 0) ++named;
    }
    EXPECT_EQ(named, model->segments->parts.size());
}

TEST(ModelSegments, AModelWhoseTimeIsOverIsKeptWithoutThem) {
    const mesh::TriangleMesh mesh = test::capsule_tree_mesh();
    const mesh::TriangleMesh coarse = mesh::decimate(mesh);
    NewModel model = test::sample_model(1, "/m/a.off");
    model.preview = make_preview(coarse);
    model.segments.reset();
    std::stop_source stopped;
    stopped.request_stop();
    add_segments(model, mesh, coarse, stopped.get_token());
    EXPECT_FALSE(model.segments);
    ASSERT_FALSE(model.summary.warnings.empty());
    EXPECT_EQ(model.summary.warnings.back().code, kSegmentsMissing);

    test::TemporaryFolder folder;
    auto store = Store::create_or_open(folder.path() / "x.ossuary", {});
    ASSERT_TRUE(store);
    const auto id = store->put(model);
    ASSERT_TRUE(id) << id.error().message;
    const auto read = store->segments(*id);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_FALSE(read->has_value());
    ASSERT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
    test::expect_sound(*store);
}

TEST(ModelSegments, OfAnotherPreviewAreNoRig) {
    const NewModel model = test::sample_model(1, "/m/a.off");
    ModelSegments other = *model.segments;
    other.labels.push_back(0);
    EXPECT_TRUE(model_rig(model.preview, *model.segments, model.skeleton, "a"));
    const auto rig = model_rig(model.preview, other, model.skeleton, "a");
    ASSERT_FALSE(rig);
    EXPECT_EQ(rig.error().code, ErrorCode::kIndexCorrupt);
}

}  // namespace
}  // namespace ossuary::index
