#include "index/model_roots.h"

#include <gtest/gtest.h>

namespace ossuary::index {
namespace {

ModelRoots roots_of(const std::vector<std::string>& paths) { return ModelRoots(paths); }

TEST(ModelRoots, AreTheFolderAboveAllModels) {
    const ModelRoots roots = roots_of({"/home/eva/models/chairs/a.off", "/home/eva/models/b.off",
                                       "/home/eva/models/chairs/old/a.off"});
    EXPECT_EQ(roots.relative("/home/eva/models/chairs/a.off"), "chairs/a.off");
    EXPECT_EQ(roots.relative("/home/eva/models/b.off"), "b.off");
    EXPECT_EQ(roots.relative("/home/eva/models/chairs/old/a.off"), "chairs/old/a.off");
}

TEST(ModelRoots, EndAtAWholeFolder) {
    const ModelRoots roots = roots_of({"/srv/models-a/x.off", "/srv/models-b/x.off"});
    EXPECT_EQ(roots.relative("/srv/models-a/x.off"), "models-a/x.off");
}

TEST(ModelRoots, AreSeveralWhereOnlyTheMachineIsCommon) {
    const ModelRoots roots =
        roots_of({"/home/eva/models/a.off", "/home/eva/models/old/b.off", "/mnt/disk/scans/c.off"});
    EXPECT_EQ(roots.relative("/home/eva/models/a.off"), "models/a.off");
    EXPECT_EQ(roots.relative("/home/eva/models/old/b.off"), "models/old/b.off");
    EXPECT_EQ(roots.relative("/mnt/disk/scans/c.off"), "scans/c.off");
}

TEST(ModelRoots, LookBeforeWhatLiesWithinAFile) {
    const ModelRoots roots =
        roots_of({"/srv/toys.zip#cars/red.stl", "/srv/toys.zip#cars/blue.stl"});
    EXPECT_EQ(roots.relative("/srv/toys.zip#cars/red.stl"), "toys.zip#cars/red.stl");
}

TEST(ModelRoots, NeverTellAWholePath) {
    EXPECT_EQ(roots_of({}).relative("/home/eva/a.off"), "a.off");
    EXPECT_EQ(roots_of({"/srv/b.off"}).relative("/home/eva/a.off"), "a.off");
    EXPECT_EQ(roots_of({"/a.off"}).relative("/a.off"), "a.off");
    EXPECT_EQ(roots_of({"/a.off", "/home/eva/b.off"}).relative("/home/eva/b.off"), "eva/b.off");
    EXPECT_EQ(roots_of({"", "/srv/models/b.off"}).relative(""), "");
    EXPECT_EQ(roots_of({"", "/srv/models/b.off"}).relative("/srv/models/b.off"), "b.off");
}

}  // namespace
}  // namespace ossuary::index
