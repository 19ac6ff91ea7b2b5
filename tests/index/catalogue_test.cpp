#include "index/catalogue.h"

#include <gtest/gtest.h>

#include "tests/index/sample_index.h"

namespace ossuary::index {
namespace {

TEST(NaturalOrder, ReadsNumbersAsNumbers) {
    const std::vector<std::string> ordered = {"",    "a",    "A1",    "a2", "a02",
                                              "a10", "a10b", "arm 2", "b",  "leg"};
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        EXPECT_FALSE(natural_less(ordered[i], ordered[i])) << ordered[i];
        for (std::size_t j = i + 1; j < ordered.size(); ++j) {
            // Equal but for zeros in front: one of both ways round, whichever.
            if (ordered[i] == "a2" && ordered[j] == "a02") {
                EXPECT_NE(natural_less("a2", "a02"), natural_less("a02", "a2"));
                continue;
            }
            EXPECT_TRUE(natural_less(ordered[i], ordered[j])) << ordered[i] << ' ' << ordered[j];
            EXPECT_FALSE(natural_less(ordered[j], ordered[i])) << ordered[i] << ' ' << ordered[j];
        }
    }
    EXPECT_TRUE(natural_less("9", "123456789012345678901234567890"));
}

TEST(Kind, IsTheEndingOfWhatHoldsTheModel) {
    EXPECT_EQ(file_kind("/srv/a.STL"), "stl");
    EXPECT_EQ(file_kind("/srv/toys.zip#cars/red.ply"), "ply");
    EXPECT_EQ(file_kind("/srv/plate.3mf#Wheel"), "3mf");
    EXPECT_EQ(file_kind("/srv/v1.2/model"), "");
    EXPECT_EQ(file_kind(""), "");
}

class CatalogueTest : public testing::Test {
protected:
    CatalogueTest() {
        add("chairs/old/leg10.off", "chair", 30);
        add("chairs/leg2.stl", "chair", 20);
        add("Leg1.off", "", 10);
        add("tables/top.stl", "table", 40);
        store_ = std::make_unique<Store>(*Store::open(file(), Access::kReadOnly));
        snapshot_ = *Snapshot::load(*store_);
    }
    std::filesystem::path file() const { return folder_.path() / "x.ossuary"; }
    void add(const std::string& path, const std::string& class_name, std::uint32_t faces) {
        auto store = Store::create_or_open(file(), {});
        auto model = test::sample_model(faces, "/srv/models/" + path);
        model.summary.name = std::filesystem::path(path).stem().string();
        model.summary.class_name = class_name;
        model.summary.faces = faces;
        // Longest sides of 10, 20, 30 and 40 mm; those of the one inch file are 1016 mm.
        model.summary.bounds = Box3(Vec3::Zero(), Vec3(1.0, static_cast<double>(faces), 2.0));
        if (faces == 30) model.summary.frame.metres_per_unit = 0.0;
        if (faces == 40) model.summary.frame.metres_per_unit = 0.0254;
        bend(model, faces / 10 - 1);
        const auto put = store->put(std::move(model));
        ASSERT_TRUE(put) << put.error().message;
    }
    /// A skeleton of two pieces with so many loops.
    static void bend(NewModel& model, std::uint32_t loops) {
        model.skeleton = {};
        model.skeleton.nodes.resize(3);
        auto& coded = model.descriptor.skeleton;
        coded.nodes.resize(2);
        coded.nodes.push_back(coded.nodes.front());
        coded.branches.clear();
        const auto add_branch = [&](std::uint32_t a, std::uint32_t b) {
            skeleton::SkeletonGraph::Branch branch;
            branch.a = a;
            branch.b = b;
            branch.points = {Vec3::Zero(), Vec3::Ones()};
            branch.radii = {0.1, 0.1};
            model.skeleton.branches.push_back(std::move(branch));
            coded.branches.push_back({a, b, "01", {0, 0, 0, 1, 1, 1}, {0.1F, 0.1F}, 1.0F});
        };
        add_branch(0, 1);
        for (std::uint32_t i = 0; i < loops; ++i) {
            add_branch(i % 2 == 0 ? 2 : 1, i % 2 == 0 ? 2 : 0);
        }
        skeleton::update_degrees(model.skeleton);
        matching::derive_matching_data(coded);
    }
    std::vector<std::string> names(const CatalogueFilter& filter,
                                   CatalogueOrder order = CatalogueOrder::kId) {
        std::vector<std::string> names;
        const auto listed = list_models(*snapshot_, *store_, filter, order);
        EXPECT_TRUE(listed);
        for (const std::size_t at : *listed) {
            names.push_back(store_->model(snapshot_->id(at))->name);
        }
        return names;
    }

    test::TemporaryFolder folder_;
    std::unique_ptr<Store> store_;
    std::shared_ptr<const Snapshot> snapshot_;
};

using Names = std::vector<std::string>;

TEST_F(CatalogueTest, ListsInEachOrder) {
    EXPECT_EQ(names({}), (Names{"leg10", "leg2", "Leg1", "top"}));
    EXPECT_EQ(names({}, CatalogueOrder::kName), (Names{"Leg1", "leg2", "leg10", "top"}));
    EXPECT_EQ(names({}, CatalogueOrder::kFaces), (Names{"top", "leg10", "leg2", "Leg1"}));
}

TEST_F(CatalogueTest, ListsWhatPassesTheFilter) {
    EXPECT_EQ(names({.name_contains = "LEG1"}), (Names{"leg10", "Leg1"}));
    EXPECT_EQ(names({.class_name = "chair"}), (Names{"leg10", "leg2"}));
    EXPECT_EQ(names({.class_name = ""}), (Names{"Leg1"}));
    EXPECT_EQ(names({.folder = "chairs"}), (Names{"leg10", "leg2"}));
    EXPECT_EQ(names({.folder = "chairs/old"}), (Names{"leg10"}));
    EXPECT_EQ(names({.folder = "chair"}), (Names{}));
    EXPECT_EQ(names({.kind = "stl"}), (Names{"leg2", "top"}));
    EXPECT_EQ(names({.class_name = "chair", .name_contains = "2", .kind = "stl"}), (Names{"leg2"}));
}

TEST_F(CatalogueTest, ListsWhatHasItsNumbersInTheRange) {
    EXPECT_EQ(names({.branches = "1-4"}), (Names{"leg10", "leg2", "Leg1", "top"}));
    EXPECT_EQ(names({.branches = "5-8"}), (Names{}));
    EXPECT_EQ(names({.loops = "0"}), (Names{"Leg1"}));
    EXPECT_EQ(names({.loops = "3-4"}), (Names{"top"}));
    EXPECT_EQ(names({.extent = "10-100mm"}), (Names{"leg2", "Leg1"}));
    EXPECT_EQ(names({.extent = "1000-10000mm"}), (Names{"top"}));
    EXPECT_EQ(names({.extent = "10-100"}), (Names{"leg10"}));
    EXPECT_EQ(names({.unit = "mm"}), (Names{"leg2", "Leg1"}));
    EXPECT_EQ(names({.unit = ""}), (Names{"leg10"}));
    EXPECT_EQ(names({.loops = "5"}), (Names{})) << "no range";
}

TEST_F(CatalogueTest, CountsRangesAscending) {
    const Facets all = *count_facets(*snapshot_, *store_, {});
    EXPECT_EQ(all.branches, (std::vector<FacetValue>{{"1-4", 4}}));
    EXPECT_EQ(all.loops, (std::vector<FacetValue>{{"0", 1}, {"1", 1}, {"2", 1}, {"3-4", 1}}));
    EXPECT_TRUE(count_facets(*snapshot_, *store_, {}, false)->loops.empty());
    EXPECT_EQ(all.extents,
              (std::vector<FacetValue>{{"10-100mm", 2}, {"1000-10000mm", 1}, {"10-100", 1}}));
    EXPECT_EQ(all.units, (std::vector<FacetValue>{{"", 1}, {"inch", 1}, {"mm", 2}}));
    const Facets mm = *count_facets(*snapshot_, *store_, {.loops = "0", .unit = "mm"});
    EXPECT_EQ(mm.units, (std::vector<FacetValue>{{"mm", 1}}));
    EXPECT_EQ(mm.loops, (std::vector<FacetValue>{{"0", 1}, {"1", 1}}));
    EXPECT_EQ(mm.extents, (std::vector<FacetValue>{{"10-100mm", 1}}));
}

TEST_F(CatalogueTest, CountsNoLoopsAgainThatHaveNotChanged) {
    const auto before = *snapshot_->loops(*store_);
    EXPECT_EQ(*before, (std::vector<std::uint32_t>{2, 1, 0, 3}));
    EXPECT_EQ(*snapshot_->loops(*store_), before) << "the same ones";
    auto writer = Store::open(file(), Access::kReadWrite);
    const std::vector<Change> remove = {RemoveModel{2}};
    ASSERT_TRUE(writer->apply(remove));
    const auto after = *Snapshot::load(*store_, snapshot_.get());
    EXPECT_EQ(**after->loops(*store_), (std::vector<std::uint32_t>{2, 0, 3}));
}

TEST_F(CatalogueTest, CountsEachFacetAsIfItWereNotChosen) {
    const Facets all = *count_facets(*snapshot_, *store_, {});
    EXPECT_EQ(all.classes, (std::vector<FacetValue>{{"", 1}, {"chair", 2}, {"table", 1}}));
    EXPECT_EQ(all.folders,
              (std::vector<FacetValue>{{"chairs", 2}, {"chairs/old", 1}, {"tables", 1}}));
    EXPECT_EQ(all.kinds, (std::vector<FacetValue>{{"off", 2}, {"stl", 2}}));
    const Facets chairs = *count_facets(*snapshot_, *store_, {.class_name = "chair"});
    EXPECT_EQ(chairs.classes, all.classes);
    EXPECT_EQ(chairs.kinds, (std::vector<FacetValue>{{"off", 1}, {"stl", 1}}));
    EXPECT_EQ(chairs.folders, (std::vector<FacetValue>{{"chairs", 2}, {"chairs/old", 1}}));
    const Facets both = *count_facets(*snapshot_, *store_, {.class_name = "chair", .kind = "off"});
    EXPECT_EQ(both.classes, (std::vector<FacetValue>{{"", 1}, {"chair", 1}}));
    EXPECT_EQ(both.kinds, chairs.kinds);
}

TEST_F(CatalogueTest, ReadsNoBlockAgainThatHasNotChanged) {
    const auto before = *snapshot_->catalogue(*store_);
    EXPECT_EQ(*snapshot_->catalogue(*store_), before) << "the same one";
    auto writer = Store::open(file(), Access::kReadWrite);
    ASSERT_TRUE(writer->put_statistics({{1.0}}, *writer->revision()));
    const auto judged = *Snapshot::load(*store_, snapshot_.get());
    EXPECT_EQ(&(**judged->catalogue(*store_))[0], &(*before)[0]) << "only statistics are new";
    const std::vector<Change> move = {MoveModel{2, "/srv/models/x.obj", "x", "other"}};
    ASSERT_TRUE(writer->apply(move));
    const auto after = *Snapshot::load(*store_, judged.get());
    const auto moved = *after->catalogue(*store_);
    EXPECT_EQ((*moved)[1].name, "x");
    EXPECT_EQ((*moved)[1].class_name, "other");
    EXPECT_EQ((*before)[1].name, "leg2");
}

}  // namespace
}  // namespace ossuary::index
