// Folders with ZIP archives, as an indexer finds them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/mesh/write_mesh.h"
#include "index/indexer.h"
#include "tests/index/sample_index.h"
#include "tests/support/shapes.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

class ArchiveIndexing : public testing::Test {
protected:
    ArchiveIndexing() { fs::create_directories(models_); }

    void write(const char* name, const std::vector<std::pair<std::string, std::string>>& members) {
        test::write_zip(models_ / name, members);
    }
    IndexOptions options() {
        IndexOptions made;
        made.paths = {models_};
        made.jobs = 2;
        made.reader = &reader_;
        return made;
    }
    IndexOutcome run(const IndexOptions& wanted) {
        ProgressSink quiet;
        const auto outcome = index_models(store_, wanted, quiet);
        EXPECT_TRUE(outcome) << outcome.error().message;
        return outcome ? *outcome : IndexOutcome{};
    }
    IndexOutcome run() { return run(options()); }
    /// Paths below the folder of models.
    std::vector<std::string> paths() {
        ModelFilter everything;
        everything.limit = 0;
        std::vector<std::string> found;
        const std::size_t before = models_.string().size() + 1;
        const auto page = store_.models(everything);
        for (const auto& model : page->models) {
            found.push_back(model.path.substr(before));
            names_.push_back(model.name + "/" + model.class_name);
        }
        return found;
    }

    test::TemporaryFolder folder_;
    fs::path models_ = folder_.path() / "models";
    ModelReader reader_;
    Store store_ = *Store::create_or_open(folder_.path() / "x.index", test::kCoarse);
    std::vector<std::string> names_;
    const std::string box_ = mesh::to_off(test::box_mesh({0, 0, 0}, {1, 2, 3}));
    const std::string bar_ = mesh::to_obj(test::box_mesh({0, 0, 0}, {1, 1, 5}));
    const std::string ring_ = mesh::to_stl(test::torus_mesh(1.0, 0.3));
};

TEST_F(ArchiveIndexing, TakesEveryModelOfEveryArchive) {
    write("one.zip", {{"readme.txt", "a ring"}, {"ring.stl", ring_}});
    write("two.ZIP", {{"long/bar.obj", bar_}, {"12.off", box_}, {"bad.off", "no mesh"}});
    write("photos.zip", {{"holiday.jpg", "no model"}});
    ASSERT_TRUE(write_whole_file(models_ / "torn.zip", "PK\3\4 and no more"));
    IndexOptions with_classes = options();
    with_classes.classes =
        ranking::parse_classification("PSB 1\n1 1\n\nblock 0 1\n12\n", "x.cla").value();
    const IndexOutcome outcome = run(with_classes);
    EXPECT_EQ(outcome.files, 5U);
    EXPECT_EQ(outcome.indexed, 3U);
    EXPECT_EQ(outcome.failed, 2U);
    EXPECT_EQ(outcome.passed_over.other_files, 1U);
    EXPECT_THAT(paths(), ElementsAre("one.zip", "two.ZIP#12.off", "two.ZIP#long/bar.obj"));
    EXPECT_THAT(names_, ElementsAre("one/", "12/block", "bar/"));
    std::vector<std::string> failures;
    const auto recorded = store_.failures();
    for (const Failure& failure : *recorded) failures.push_back(failure.code);
    EXPECT_THAT(failures, UnorderedElementsAre("archive_invalid", "format_unknown"));

    const IndexOutcome again = run(with_classes);
    EXPECT_EQ(again.unchanged, 3U);
    EXPECT_EQ(again.known_failures + again.failed, 2U);
    EXPECT_EQ(again.indexed, 0U);
}

TEST_F(ArchiveIndexing, PassesOverWhatIsExcludedAsInAFolder) {
    write("a.zip", {{"old/bar.obj", bar_}, {"box.off", box_}});
    IndexOptions some = options();
    some.walk.exclude = {*Glob::parse("old/")};
    const IndexOutcome outcome = run(some);
    EXPECT_EQ(outcome.indexed, 1U);
    EXPECT_EQ(outcome.passed_over.excluded, 1U);
    EXPECT_THAT(paths(), ElementsAre("a.zip#box.off"));
}

TEST_F(ArchiveIndexing, TakesAModelOfAnArchiveThatIsNamed) {
    write("a.zip", {{"bar.obj", bar_}, {"box.off", box_}});
    IndexOptions one = options();
    one.paths = {models_ / "a.zip#bar.obj"};
    EXPECT_EQ(run(one).indexed, 1U);
    EXPECT_THAT(paths(), ElementsAre("a.zip#bar.obj"));
    one.paths = {models_ / "b.zip#bar.obj"};
    ProgressSink quiet;
    EXPECT_EQ(index_models(store_, one, quiet).error().code, ErrorCode::kFileNotFound);
}

TEST_F(ArchiveIndexing, PrunesWhatIsNoLongerInAnArchive) {
    write("a.zip", {{"bar.obj", bar_}, {"box.off", box_}, {"ring.stl", ring_}});
    write("b.zip", {{"box.off", box_}});
    EXPECT_EQ(run().indexed, 4U);
    IndexOptions prune = options();
    prune.prune = Prune::kYes;
    EXPECT_EQ(run(prune).pruned, 0U);

    // One gone, and one archive that has become two models.
    write("a.zip", {{"bar.obj", bar_}, {"ring.stl", ring_}});
    write("b.zip",
          {{"box.off", box_}, {"tall.obj", mesh::to_obj(test::box_mesh({0, 0, 0}, {1, 1, 9}))}});
    const IndexOutcome outcome = run(prune);
    EXPECT_EQ(outcome.pruned, 2U);
    EXPECT_THAT(paths(), UnorderedElementsAre("a.zip#bar.obj", "a.zip#ring.stl", "b.zip#box.off",
                                              "b.zip#tall.obj"));
    // One that cannot be opened keeps what is known of it.
    ASSERT_TRUE(write_whole_file(models_ / "a.zip", "torn"));
    EXPECT_EQ(run(prune).pruned, 0U);
    fs::remove(models_ / "a.zip");
    EXPECT_EQ(run(prune).pruned, 2U);
    EXPECT_THAT(paths(), UnorderedElementsAre("b.zip#box.off", "b.zip#tall.obj"));
}

TEST_F(ArchiveIndexing, FollowsAModelOutOfItsArchive) {
    write("a.zip", {{"bar.obj", bar_}, {"box.off", box_}});
    EXPECT_EQ(run().indexed, 2U);
    fs::remove(models_ / "a.zip");
    ASSERT_TRUE(write_whole_file(models_ / "box.off", box_));
    const IndexOutcome outcome = run();
    EXPECT_EQ(outcome.moved, 1U);
    EXPECT_EQ(outcome.indexed, 0U);
}

/// Two boxes and a ring as one OBJ.
std::string plate() {
    const auto moved = [](mesh::TriangleMesh mesh, double x) {
        for (Vec3& vertex : mesh.vertices) vertex.x() += x;
        return mesh;
    };
    std::string text;
    std::size_t before = 0;
    for (const auto& [name, mesh] :
         {std::pair("block", test::box_mesh({0, 0, 0}, {1, 2, 3})),
          std::pair("block", moved(test::box_mesh({0, 0, 0}, {1, 1, 5}), 8.0)),
          std::pair("ring", moved(test::torus_mesh(1.0, 0.3), 16.0))}) {
        text += "o " + std::string(name) + "\n";
        for (const Vec3& v : mesh.vertices) {
            text += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
                    std::to_string(v.z()) + "\n";
        }
        for (const auto& t : mesh.triangles) {
            text += "f";
            for (const std::uint32_t v : t) text += " " + std::to_string(before + v + 1);
            text += "\n";
        }
        before += mesh.vertices.size();
    }
    return text;
}

TEST_F(ArchiveIndexing, SplitsFilesIntoTheirObjects) {
    ASSERT_TRUE(write_whole_file(models_ / "plate.obj", plate()));
    ASSERT_TRUE(write_whole_file(models_ / "box.off", box_));
    write("a.zip", {{"plate.obj", plate()}, {"bar.obj", bar_}});
    IndexOptions split = options();
    split.split = true;
    EXPECT_EQ(run(split).indexed, 8U);
    EXPECT_THAT(paths(), ElementsAre("a.zip#bar.obj", "a.zip#plate.obj#block",
                                     "a.zip#plate.obj#block (2)", "a.zip#plate.obj#ring", "box.off",
                                     "plate.obj#block", "plate.obj#block (2)", "plate.obj#ring"));
    EXPECT_THAT(names_, ElementsAre("bar/", "block/", "block (2)/", "ring/", "box/", "block/",
                                    "block (2)/", "ring/"));
    EXPECT_EQ(run(split).unchanged, 8U);
    // Placed as in the file.
    const auto ring = reader_.read(models_ / "plate.obj#ring");
    ASSERT_TRUE(ring) << ring.error().message;
    EXPECT_EQ(ring->mesh.triangles.size(), test::torus_mesh(1.0, 0.3).triangles.size());
    EXPECT_NEAR(ring->mesh.vertices.front().x(), 16.0, 1.5);
    const auto none = reader_.read(models_ / "plate.obj#wheel");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::kObjectMissing);
    EXPECT_THAT(none.error().message, testing::HasSubstr("'block', 'block (2)', 'ring'"));
}

TEST_F(ArchiveIndexing, PrunesWhatSplittingHasPutInItsPlace) {
    ASSERT_TRUE(write_whole_file(models_ / "plate.obj", plate()));
    EXPECT_EQ(run().indexed, 1U);
    IndexOptions split = options();
    split.split = true;
    split.prune = Prune::kYes;
    EXPECT_EQ(run(split).indexed, 3U);
    EXPECT_THAT(paths(), ElementsAre("plate.obj#block", "plate.obj#block (2)", "plate.obj#ring"));
    split.split = false;
    const IndexOutcome whole = run(split);
    EXPECT_EQ(whole.indexed, 1U);
    EXPECT_EQ(whole.pruned, 3U);
    EXPECT_THAT(paths(), ElementsAre("plate.obj"));
}

}  // namespace
}  // namespace ossuary::index
