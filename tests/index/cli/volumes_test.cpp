#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/whole_file.h"
#include "tests/index/cli/run_program.h"
#include "tests/support/packed.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

// What of a volume is the model, through every command that takes one.
namespace ossuary::test {
namespace {

using ::testing::HasSubstr;

/// A bar of label 1 below a ring of label 2; 0 elsewhere.
int label_at(const Vec3i& at) {
    const double across = std::hypot(at.x() - 20.0, at.y() - 20.0);
    if (at.z() >= 3 && at.z() < 9 && at.x() >= 3 && at.x() < 37 && std::abs(at.y() - 20) < 3)
        return 1;
    return std::hypot(across - 12.0, at.z() - 18.0) < 4.0 ? 2 : 0;
}

class Volumes : public ::testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directory(folder_.path() / "models");
        const std::string volume = to_nrrd({40, 40, 24}, label_at);
        ASSERT_TRUE(write_whole_file(labels(), volume));
        ASSERT_TRUE(write_whole_file(folder_.path() / "models/packed.nrrd.gz", gzipped(volume)));
    }
    [[nodiscard]] std::string labels() const { return folder_.path() / "models/labels.nrrd"; }
    [[nodiscard]] std::string index_file() const { return folder_.path() / "some.ossuary"; }
    ProgramResult run(std::vector<std::string> arguments) {
        return run_ossuary(arguments, folder_.path());
    }
    int cycles(const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"skeleton", labels(), "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exit_status, 0) << result.err;
        return result.exit_status == 0 ? result.json().at("cycles").get<int>() : -1;
    }

    TemporaryFolder folder_;
};

TEST_F(Volumes, AreWhatTheLabelOrTheThresholdSays) {
    EXPECT_EQ(cycles({"--label", "1"}), 0);
    EXPECT_EQ(cycles({"--label", "2"}), 1);
    EXPECT_EQ(cycles({"--threshold", "1.5"}), 1);
    const ProgramResult said = run({"skeleton", labels(), "--json", "--label", "2"});
    EXPECT_TRUE(said.json().at("warnings").empty()) << said.out;
    const ProgramResult found = run({"skeleton", labels(), "--json"});
    EXPECT_EQ(found.json().at("warnings")[0].at("code"), "volume_inside");
    const ProgramResult cut = run({"segment", labels(), "--json", "--label", "1"});
    EXPECT_EQ(cut.exit_status, 0) << cut.err;
    const ProgramResult same = run(
        {"compare", labels(), folder_.path() / "models/packed.nrrd.gz", "--label", "2", "--json"});
    ASSERT_EQ(same.exit_status, 0) << same.err;
    EXPECT_NEAR(same.json().at("distance").get<double>(), 0.0, 1e-9);
}

TEST_F(Volumes, AreRefusedWhereNothingIsInsideOrTheQuestionIsNone) {
    const ProgramResult empty = run({"skeleton", labels(), "--label", "7"});
    EXPECT_EQ(empty.exit_status, 1);
    EXPECT_THAT(empty.err, HasSubstr("solid_empty"));
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--label", "1", "--threshold", "1"},
          {"--label", "one"},
          {"--threshold", "nan"},
          {"--threshold", "inf"}}) {
        std::vector<std::string> arguments = {"skeleton", labels()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run(arguments).exit_status, 2) << options[1];
    }
}

TEST_F(Volumes, AreIndexedAnewWhereAnotherAnswerIsGiven) {
    const auto index = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"index",
                                              "--index",
                                              index_file(),
                                              "--resolution",
                                              "24",
                                              "--json",
                                              folder_.path() / "models"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exit_status, 0) << result.err;
        return std::pair(result.json().at("indexed").get<int>(),
                         result.json().at("unchanged").get<int>());
    };
    EXPECT_EQ(index({"--label", "1"}), std::pair(2, 0));
    EXPECT_EQ(index({"--label", "1"}), std::pair(0, 2));
    EXPECT_EQ(index({"--label", "2"}), std::pair(2, 0));
    const ProgramResult ring =
        run({"search", "--index", index_file(), labels(), "--label", "2", "--json"});
    ASSERT_EQ(ring.exit_status, 0) << ring.err;
    EXPECT_NEAR(ring.json().at("hits")[0].at("distance").get<double>(), 0.0, 1e-6);
    const ProgramResult bar =
        run({"search", "--index", index_file(), labels(), "--label", "1", "--json"});
    EXPECT_GT(bar.json().at("hits")[0].at("distance").get<double>(), 0.1);
    EXPECT_EQ(index({}), std::pair(2, 0));
}

}  // namespace
}  // namespace ossuary::test
