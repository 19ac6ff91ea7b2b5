#include "index/upright.h"

#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <string_view>

#include "engine/mesh/decimate.h"
#include "engine/mesh/read_mesh.h"
#include "engine/mesh/write_mesh.h"
#include "index/turn_model.h"
#include "tests/index/sample_index.h"
#include "tests/support/benchmark_data.h"
#include "tests/support/shapes.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;

/// Adds a box between two corners.
void add_box(mesh::TriangleMesh& mesh, const Vec3& low, const Vec3& high) {
    const mesh::TriangleMesh box = test::box_mesh(low, high);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), box.vertices.begin(), box.vertices.end());
    for (const auto& [a, b, c] : box.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.face_of_triangle.push_back(mesh.face_count++);
    }
}

/// A table, y up: it rests on four legs.
mesh::TriangleMesh table() {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 9, 0}, {20, 10, 12});
    for (const double x : {1.0, 18.0}) {
        for (const double z : {1.0, 10.0}) add_box(mesh, {x, 0, z}, {x + 1, 9, z + 1});
    }
    return mesh;
}

/// A lamp on a foot, y up.
mesh::TriangleMesh lamp() {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {10, 1, 10});
    add_box(mesh, {4.5, 1, 4.5}, {5.5, 15.3, 5.5});
    add_box(mesh, {2, 15.3, 2}, {8, 20, 8});
    return mesh;
}

/// The same model as a program with z up writes it.
mesh::TriangleMesh with_z_up(mesh::TriangleMesh mesh) {
    for (Vec3& vertex : mesh.vertices) vertex = {vertex.x(), -vertex.z(), vertex.y()};
    return mesh;
}

TEST(Upright, FindsTheAxisThatWasTurned) {
    for (const mesh::TriangleMesh& mesh : {table(), lamp()}) {
        for (const Up convention : {Up::kY, Up::kZ}) {
            EXPECT_EQ(find_up(mesh, convention), Up::kY);
            EXPECT_EQ(find_up(with_z_up(mesh), convention), Up::kZ);
        }
    }
}

TEST(Upright, IsTheConventionWhereNothingSpeaksAgainstIt) {
    for (const mesh::TriangleMesh& mesh :
         {test::box_mesh({0, 0, 0}, {1, 1, 1}), test::icosphere_mesh({0, 0, 0}, 1.0)}) {
        EXPECT_EQ(find_up(mesh, Up::kY), Up::kY);
        EXPECT_EQ(find_up(mesh, Up::kZ), Up::kZ);
    }
    EXPECT_EQ(find_up({}, Up::kZ), Up::kZ);
}

TEST(Upright, WeighsFootprintAndLopsidedness) {
    const UprightEvidence standing = upright_evidence(table(), Up::kY);
    EXPECT_GT(standing.footprint, 0.7) << "what its legs span";
    EXPECT_LT(standing.footprint, 0.9);
    EXPECT_GT(standing.lopsidedness, 0.3);
    const UprightEvidence lying = upright_evidence(table(), Up::kZ);
    EXPECT_LT(lying.footprint, 0.2) << "the edge of its top";
    EXPECT_LT(lying.lopsidedness, 0.05);
}

TEST(Upright, DoesNotDependOnSizePlaceOrUnusedVertices) {
    for (const Up up : {Up::kY, Up::kZ}) {
        const UprightEvidence plain = upright_evidence(lamp(), up);
        mesh::TriangleMesh mesh = lamp();
        for (Vec3& vertex : mesh.vertices) vertex = 1e-3 * vertex + Vec3(5e3, -7e2, 1e4);
        mesh.vertices.emplace_back(0, 0, 0);
        const UprightEvidence moved = upright_evidence(mesh, up);
        EXPECT_NEAR(moved.footprint, plain.footprint, 1e-6);
        EXPECT_NEAR(moved.lopsidedness, plain.lopsidedness, 1e-2);
    }
}

TEST(Upright, TurnsThumbnailsAlone) {
    // The picture of a model that was turned is that of the model that was not.
    const auto upright = render_thumbnail(lamp(), thumbnail_options(Up::kY));
    const auto turned = render_thumbnail(with_z_up(lamp()), thumbnail_options(Up::kZ));
    const auto fallen = render_thumbnail(with_z_up(lamp()), thumbnail_options(Up::kY));
    ASSERT_TRUE(upright && turned && fallen);
    EXPECT_EQ(*turned, *upright);
    EXPECT_NE(*fallen, *upright);
    EXPECT_EQ(*render_thumbnail(lamp()), *upright) << "as ever";
}

TEST(Upright, DrawsModelsUprightWhoseXAxisPointsUp) {
    mesh::TriangleMesh lying = lamp();
    for (Vec3& vertex : lying.vertices) vertex = Vec3(vertex.y(), -vertex.x(), vertex.z());
    const auto upright = render_thumbnail(lamp(), thumbnail_options(Up::kY));
    const auto turned = render_thumbnail(lying, thumbnail_options(Up::kX));
    ASSERT_TRUE(upright && turned);
    EXPECT_EQ(*turned, *upright);
}

/// An index with two copies of a model, one on its back.
class Turning : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directory(models_);
        ASSERT_TRUE(mesh::write_off(lamp(), models_ / "a.off"));
        ASSERT_TRUE(mesh::write_off(with_z_up(lamp()), models_ / "b.off"));
        auto opened = Store::create_or_open(folder_.path() / "x.index", test::kCoarse);
        ASSERT_TRUE(opened);
        store_.emplace(*std::move(opened));
    }
    IndexOutcome index(std::optional<Up> up = {}) {
        IndexOptions options;
        options.paths = {models_};
        options.up = up;
        ProgressSink quiet;
        const auto outcome = index_models(*store_, options, quiet);
        EXPECT_TRUE(outcome) << outcome.error().message;
        return outcome ? *outcome : IndexOutcome{};
    }
    Orientation orientation(ModelId id) { return store_->model(id)->orientation; }

    test::TemporaryFolder folder_;
    fs::path models_ = folder_.path() / "models";
    std::optional<Store> store_;
};

TEST_F(Turning, FindsWhatStandsHowWhenIndexing) {
    index();
    EXPECT_EQ(orientation(1), (Orientation{Up::kY, false}));
    EXPECT_EQ(orientation(2), (Orientation{Up::kZ, false}));
    EXPECT_EQ(*store_->thumbnail(1), *store_->thumbnail(2));
    test::expect_sound(*store_);
}

TEST_F(Turning, ChangesThePictureAndNothingThatIsSearched) {
    index();
    const auto before = *store_->thumbnail(1);
    const Revision revision = *store_->revision();
    EXPECT_EQ(*turn_model(*store_, 1, Up::kZ), (Orientation{Up::kZ, true}));
    EXPECT_EQ(orientation(1), (Orientation{Up::kZ, true}));
    EXPECT_NE(*store_->thumbnail(1), before);
    EXPECT_EQ(*store_->revision(), revision);
    EXPECT_EQ(store_->collection_state()->statistics, revision);
    EXPECT_EQ(*turn_model(*store_, 1, {}), (Orientation{Up::kY, false}));
    // So small a mesh is its own preview, but for rounding.
    const auto again = *store_->thumbnail(1);
    EXPECT_NEAR(static_cast<double>(again.size()), static_cast<double>(before.size()),
                0.02 * static_cast<double>(before.size()));
    ASSERT_TRUE(turn_model(*store_, 1, Up::kZ));
    ASSERT_TRUE(turn_model(*store_, 1, {}));
    EXPECT_EQ(*store_->thumbnail(1), again);
    EXPECT_EQ(turn_model(*store_, 9, Up::kZ).error().code, ErrorCode::kModelNotFound);
    test::expect_sound(*store_);
}

TEST_F(Turning, KeepsWhatAPersonSaidWhenTheFileChanges) {
    index();
    ASSERT_TRUE(turn_model(*store_, 1, Up::kZ));
    EXPECT_EQ(index().turned, 0U);
    EXPECT_EQ(orientation(1), (Orientation{Up::kZ, true}));
    ASSERT_TRUE(mesh::write_off(table(), models_ / "a.off"));
    ASSERT_TRUE(mesh::write_off(table(), models_ / "b.off"));
    EXPECT_EQ(index().indexed, 2U);
    EXPECT_EQ(orientation(1), (Orientation{Up::kZ, true}));
    EXPECT_EQ(orientation(2), (Orientation{Up::kY, false})) << "found anew";
}

TEST_F(Turning, TakesTheAxisThatIsNamedForNewAndOldModels) {
    index(Up::kZ);
    EXPECT_EQ(orientation(1), (Orientation{Up::kZ, true}));
    const IndexOutcome outcome = index(Up::kY);
    EXPECT_EQ(outcome.turned, 2U);
    EXPECT_EQ(outcome.unchanged, 2U);
    EXPECT_EQ(orientation(2), (Orientation{Up::kY, true}));
    EXPECT_EQ(index(Up::kY).turned, 0U);
    EXPECT_EQ(index().turned, 0U);
    fs::rename(models_ / "a.off", models_ / "c.off");
    EXPECT_EQ(index(Up::kZ).moved, 1U);
    EXPECT_EQ(orientation(1), (Orientation{Up::kZ, true}));
    test::expect_sound(*store_);
}

TEST_F(Turning, LeavesModelsOfEarlierIndexesAsTheyWere) {
    const fs::path path = folder_.path() / "old.index";
    test::make_old_index(path, 3, test::sample_model(3, "/m/a.off"));
    auto store = Store::open(path, Access::kReadWrite);
    ASSERT_TRUE(store) << store.error().message;
    EXPECT_EQ(store->model(1)->orientation, Orientation{});
    EXPECT_EQ(turn_model(*store, 1, Up::kZ)->up, Up::kZ);
    EXPECT_EQ(store->model(1)->orientation.up, Up::kZ);
    ASSERT_TRUE(store->put_statistics({{1.0}}, *store->revision()));
    test::expect_sound(*store);
}

TEST_F(Turning, GoesBackToWhatTheFileSays) {
    NewModel model = test::sample_model(3, "/m/a.dae");
    model.summary.frame = {0.0254, Up::kX};
    model.summary.orientation = {Up::kX, false};
    const auto id = store_->put(model);
    ASSERT_TRUE(id) << id.error().message;
    EXPECT_EQ(*turn_model(*store_, *id, Up::kY), (Orientation{Up::kY, true}));
    EXPECT_EQ(*turn_model(*store_, *id, {}), (Orientation{Up::kX, false}));
    EXPECT_EQ(store_->model(*id)->frame, model.summary.frame);
}

TEST_F(Turning, IsVerified) {
    index();
    test::execute_sql(folder_.path() / "x.index",
                      "PRAGMA ignore_check_constraints = 1; UPDATE orientations SET up = 'w' WHERE "
                      "model = 1;");
    EXPECT_EQ(store_->model(1).error().code, ErrorCode::kIndexCorrupt);
    EXPECT_FALSE(store_->verify()->findings.empty());
}

/// How models of the segmentation benchmark stand, seen by eye: their first number, then for each
/// the axis that points up in its file, or - for one that lies askew. The classes that are left out
/// (octopuses, hands, pliers, mechanical parts) stand by no axis.
struct Labels {
    int first;
    std::string_view axes;
};
constexpr Labels kLabels[] = {
    {1, "zyyyyyzzzyzzyyyyyyyy"},   {21, "yyyyyzzyyyyyyzy--yyy"},  {41, "zzyyyzzzzzzzzyyzzzzz"},
    {61, "zyyzzzzzzzzzzzzzyzzz"},  {81, "zzzzzzzzzzzzzyzzzzzz"},  {101, "yyyzzzyyyyyyyyyyyyyy"},
    {141, "-yyyyyyyyyyyzzyyyyz-"}, {161, "yyyyyyyyyyyyyyyyyyyy"}, {221, "zzyyyzzzyyyyyyyyyyyy"},
    {241, "yyzyyyyyyzzyy-yyy--y"}, {281, "yyyyyyyyyyyyyyyyyyyy"}, {301, "yyy-yyzyzyy-yyyyyy-y"},
    {361, "yyyyyyzyyyyyyyyyyyzy"}, {381, "yzz-yzyyzyyyyzyyyyyy"}};

TEST(UprightOnTheBenchmark, IsRightMoreOftenThanTheConvention) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    std::size_t models = 0, of_convention = 0, right = 0, right_z = 0;
    for (const Labels& labels : kLabels) {
        for (std::size_t i = 0; i < labels.axes.size(); ++i) {
            if (labels.axes[i] == '-') continue;
            const std::string name = std::to_string(labels.first + static_cast<int>(i)) + ".off";
            const auto read = mesh::read_mesh(data / "princeton-segmentation" / "off" / name);
            ASSERT_TRUE(read) << read.error().message;
            const Up up = find_up(mesh::decimate(read->mesh, {.max_triangles = 2000}));
            const bool is_right = to_string(up)[0] == labels.axes[i];
            ++models;
            of_convention += labels.axes[i] == 'y' ? 1 : 0;
            right += is_right ? 1 : 0;
            right_z += is_right && up == Up::kZ ? 1 : 0;
        }
    }
    std::cout << right << " of " << models << " models stand upright, " << right_z << " of "
              << models - of_convention << " with z up; " << of_convention
              << " would if y were always up\n";
    EXPECT_EQ(models, 269U);
    EXPECT_GT(right, of_convention + 30);
    EXPECT_GT(right_z, 55U);
}

}  // namespace
}  // namespace ossuary::index
