#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "engine/mesh/read_mesh.h"
#include "tests/index/cli/run_program.h"
#include "tests/index/sample_index.h"

// The command line that scripts depend on: exit statuses, stdout apart from stderr, JSON fields.
namespace ossuary::test {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr int kModels = 6;

class CommandLineTest : public ::testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directory(models());
        write_sample_meshes(models(), kModels);
    }

    [[nodiscard]] std::filesystem::path models() const { return folder_.path() / "models"; }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
    [[nodiscard]] std::string index_file() const { return path("some.ossuary"); }
    [[nodiscard]] std::vector<std::filesystem::path> model_files() const {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(models())) {
            files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
        return files;
    }

    ProgramResult run(std::vector<std::string> arguments) {
        return run_ossuary(arguments, folder_.path());
    }
    ProgramResult build_index() {
        return run({"index", "--index", index_file(), "--resolution", "24", "--json", models()});
    }
    /// Two classes of three models each, in the order of the files' names.
    [[nodiscard]] std::string write_classes() const {
        std::string text = "PSB 1\n2 6\n";
        const auto files = model_files();
        for (std::size_t i = 0; i < files.size(); ++i) {
            if (i % 3 == 0) text += i == 0 ? "\nfirst 0 3\n" : "\nsecond 0 3\n";
            text += files[i].stem().string() + "\n";
        }
        write_file(path("two.cla"), text);
        return path("two.cla");
    }

    TemporaryFolder folder_;
};

TEST_F(CommandLineTest, HelpAndVersionGoToStdoutWithStatusZero) {
    for (const char* command : {"index", "search", "compare", "evaluate", "skeleton", "thin",
                                "models", "show", "remove", "up", "verify", "export"}) {
        const ProgramResult help = run({command, "--help"});
        EXPECT_EQ(help.exit_status, 0) << command;
        EXPECT_THAT(help.out, HasSubstr("--json")) << command;
        EXPECT_THAT(help.err, IsEmpty()) << command;
    }
    EXPECT_THAT(run({"--version"}).out, StartsWith("ossuary "));
}

TEST_F(CommandLineTest, WrongUsageIsStatusTwoAndSaysWhat) {
    const ProgramResult nothing = run({});
    EXPECT_EQ(nothing.exit_status, 2);
    EXPECT_THAT(nothing.out, IsEmpty());
    const ProgramResult option = run({"models", "--index", index_file(), "--no-such-option"});
    EXPECT_EQ(option.exit_status, 2);
    EXPECT_THAT(option.err, HasSubstr("--no-such-option"));
    const ProgramResult ranker =
        run({"compare", model_files()[0], model_files()[1], "--ranker", "best"});
    EXPECT_EQ(ranker.exit_status, 2);
    EXPECT_THAT(ranker.err, HasSubstr("best"));
}

TEST_F(CommandLineTest, IndexCountsWhatItDidAndSkipsItTheNextTime) {
    const ProgramResult first = build_index();
    ASSERT_EQ(first.exit_status, 0) << first.err;
    EXPECT_EQ(first.json().at("indexed"), kModels);
    const ProgramResult second = build_index();
    ASSERT_EQ(second.exit_status, 0) << second.err;
    EXPECT_EQ(second.json().at("indexed"), 0);
    EXPECT_EQ(second.json().at("unchanged"), kModels);
}

TEST_F(CommandLineTest, IndexWithABadModelIsStatusThreeAndNamesTheFile) {
    write_file(models() / "short.off", "OFF\n3 1 0\n0 0 0\n");
    const ProgramResult result = build_index();
    EXPECT_EQ(result.exit_status, 3);
    EXPECT_EQ(result.json().at("indexed"), kModels);
    EXPECT_EQ(result.json().at("failed"), 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr("off_truncated"), HasSubstr("short.off, line 4")));
    const nlohmann::json shown = run({"show", "--index", index_file(), "--json"}).json();
    ASSERT_EQ(shown.at("failures").size(), 1);
    EXPECT_THAT(shown.at("failures")[0].at("path").get<std::string>(), HasSubstr("short.off"));
}

TEST_F(CommandLineTest, WhatIsNoIndexIsStatusFour) {
    write_file(path("text.ossuary"), "this is not a database, whatever its name may say\n");
    for (const std::string& file : {path("absent.ossuary"), path("text.ossuary")}) {
        for (const char* command : {"models", "verify", "show"}) {
            const ProgramResult result = run({command, "--index", file});
            EXPECT_EQ(result.exit_status, 4) << command << " " << file;
            EXPECT_THAT(result.out, IsEmpty());
            EXPECT_THAT(result.err, HasSubstr("index_")) << command;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(path("absent.ossuary")));
}

TEST_F(CommandLineTest, OtherParametersThanTheIndexHasAreStatusFour) {
    ASSERT_EQ(build_index().exit_status, 0);
    const ProgramResult other =
        run({"index", "--index", index_file(), "--resolution", "32", models()});
    EXPECT_EQ(other.exit_status, 4);
    EXPECT_THAT(other.err, HasSubstr("index_parameters"));
}

TEST_F(CommandLineTest, SearchFindsTheModelItselfFirst) {
    ASSERT_EQ(build_index().exit_status, 0);
    const std::filesystem::path query = model_files()[2];
    for (const char* ranker : {"hybrid", "skeleton", "chain-code"}) {
        const nlohmann::json found = run({"search", "--index", index_file(), query, "--ranker",
                                          ranker, "--limit", "3", "--json"})
                                         .json();
        ASSERT_EQ(found.at("hits").size(), 3) << ranker;
        const nlohmann::json& best = found.at("hits")[0];
        EXPECT_EQ(best.at("name"), query.stem().string()) << ranker;
        EXPECT_EQ(best.at("rank"), 1);
        EXPECT_NEAR(best.at("distance").get<double>(), 0.0, 1e-6) << ranker;
        for (const char* field : {"id", "class", "parts", "matched_nodes"}) {
            EXPECT_TRUE(best.contains(field)) << field;
        }
        EXPECT_GT(found.at("took_ms").get<double>(), 0.0);
        EXPECT_FALSE(found.at("stages_ms").empty());
    }
}

TEST_F(CommandLineTest, SearchWithABadModelIsStatusOneWithItsCodeAndLine) {
    ASSERT_EQ(build_index().exit_status, 0);
    write_file(path("bad.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    const ProgramResult result = run({"search", "--index", index_file(), path("bad.off")});
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, AllOf(HasSubstr("off_index_out_of_range"), HasSubstr("line 6")));
}

/// The corners of a mesh's triangles and the middles of their sides, a line each.
std::string points_of(const std::filesystem::path& model) {
    const auto read = mesh::read_mesh(model);
    std::string text;
    for (std::size_t t = 0; t < read->mesh.triangles.size(); ++t) {
        const auto corners = read->mesh.corners(t);
        for (std::size_t i = 0; i < 3; ++i) {
            for (const Vec3& at : {corners[i], Vec3((corners[i] + corners[(i + 1) % 3]) / 2)}) {
                text += fmt::format("{} {} {}\n", at.x(), at.y(), at.z());
            }
        }
    }
    return text;
}

TEST_F(CommandLineTest, PointsFindTheModelThatTheyAreOf) {
    write_file(models() / "zz_points.xyz", points_of(model_files()[2]));
    const ProgramResult indexed = build_index();
    ASSERT_EQ(indexed.exit_status, 0) << indexed.err;
    EXPECT_EQ(indexed.json().at("indexed"), kModels + 1);
    const nlohmann::json shown =
        run({"show", "--index", index_file(), "zz_points", "--json"}).json();
    EXPECT_THAT(shown.dump(), HasSubstr("points_wrapped"));
    const nlohmann::json found =
        run({"search", "--index", index_file(), models() / "zz_points.xyz", "--json"}).json();
    EXPECT_EQ(found.at("hits")[0].at("name"), "zz_points");
    EXPECT_EQ(found.at("hits")[1].at("name"), model_files()[2].stem().string());
    const ProgramResult cut = run({"segment", models() / "zz_points.xyz", "--out", path("p.ply")});
    EXPECT_EQ(cut.exit_status, 0) << cut.err;
    write_file(path("few.xyz"), "0.5 0 0\n1 0 0\n0 1 0\n");
    const ProgramResult few = run({"skeleton", path("few.xyz")});
    EXPECT_EQ(few.exit_status, 1);
    EXPECT_THAT(few.err, HasSubstr("points_too_few"));
}

TEST_F(CommandLineTest, SearchesForAPart) {
    ASSERT_EQ(build_index().exit_status, 0);
    const ProgramResult result =
        run({"search", "--index", index_file(), model_files()[1], "--part", "--json"});
    ASSERT_EQ(result.exit_status, 0) << result.err;
    const nlohmann::json found = result.json();
    EXPECT_EQ(found.at("part"), true);
    EXPECT_EQ(found.at("hits").at(0).at("name"), model_files()[1].stem().string());
    EXPECT_LT(found.at("hits").at(0).at("distance").get<double>(), 0.1);
    EXPECT_NEAR(found.at("hits").at(0).at("placement").at("scale").get<double>(), 1.0, 0.02);
    const nlohmann::json compared = run({"compare", model_files()[1], model_files()[2], "--part",
                                         "--resolution", "24", "--json"})
                                        .json();
    for (const nlohmann::json& hit : found.at("hits")) {
        if (hit.at("name") != model_files()[2].stem().string()) continue;
        for (const char* field : {"matched_nodes", "match"}) {
            EXPECT_EQ(hit.at(field), compared.at(field)) << field;
        }
    }
    EXPECT_EQ(run({"search", "--index", index_file(), model_files()[1], "--part", "--rerank"})
                  .exit_status,
              2);
}

TEST_F(CommandLineTest, CompareOfAModelWithItselfIsZeroAndSymmetricOtherwise) {
    const auto files = model_files();
    const auto distance = [&](std::size_t a, std::size_t b) {
        return run({"compare", files[a], files[b], "--resolution", "24", "--ranker", "skeleton",
                    "--json"})
            .json()
            .at("distance")
            .get<double>();
    };
    EXPECT_NEAR(distance(1, 1), 0.0, 1e-9);
    EXPECT_NEAR(distance(0, 1), distance(1, 0), 1e-9);
    EXPECT_GT(distance(0, 1), 0.0);
}

TEST_F(CommandLineTest, EvaluatePrintsTheFixedFieldsAndWritesMatrixAndReport) {
    ASSERT_EQ(build_index().exit_status, 0);
    const ProgramResult result =
        run({"evaluate", "--index", index_file(), "--classes", write_classes(), "--ranker",
             "skeleton", "--matrix", path("d.matrix"), "--out", path("report"), "--json"});
    ASSERT_EQ(result.exit_status, 0) << result.err;
    const nlohmann::json document = result.json();
    EXPECT_EQ(document.at("models"), kModels);
    EXPECT_EQ(document.at("classes"), 2);
    EXPECT_EQ(document.at("ranker"), "skeleton");
    EXPECT_EQ(document.at("rerank"), false);
    for (const char* metric : {"nearest_neighbor", "first_tier", "second_tier", "e_measure", "dcg",
                               "mean_average_precision"}) {
        const double value = document.at(metric).get<double>();
        EXPECT_TRUE(value >= 0.0 && value <= 1.0) << metric << " " << value;
    }
    EXPECT_EQ(document.at("per_class").size(), 2);
    EXPECT_TRUE(document.at("precision_recall")[0].contains("recall"));
    EXPECT_TRUE(document.at("precision_recall")[0].contains("precision"));

    const std::string matrix = read_file(path("d.matrix"));
    ASSERT_EQ(matrix.size(), sizeof(float) * kModels * kModels);
    for (std::size_t row = 0; row < kModels; ++row) {
        float self = 1.0F;
        std::memcpy(&self, matrix.data() + sizeof(float) * (row * kModels + row), sizeof self);
        EXPECT_EQ(self, 0.0F) << "model " << row << " against itself";
    }
    EXPECT_THAT(read_file(path("report/report.html")), HasSubstr("<svg"));
}

TEST_F(CommandLineTest, EvaluateAsksForTheSameBuildAndTheSamePose) {
    ASSERT_EQ(build_index().exit_status, 0);
    const std::string classes = write_classes();
    const ProgramResult result =
        run({"evaluate", "--index", index_file(), "--build-classes", classes, "--pose-classes",
             classes, "--ranker", "skeleton,chain-code", "--out", path("asked"), "--json"});
    ASSERT_EQ(result.exit_status, 0) << result.err;
    const nlohmann::json document = result.json();
    ASSERT_EQ(document.size(), 2);
    EXPECT_EQ(document[0].at("models"), kModels);
    EXPECT_EQ(document[0].at("curve").size(), 8);
    EXPECT_EQ(document[1].at("curve").size(), 1);
    EXPECT_THAT(read_file(path("asked/poses.html")), HasSubstr("<polyline"));
    EXPECT_THAT(read_file(path("asked/build-and-pose.csv")), HasSubstr("skeleton,0,0.15,build,"));

    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--build-classes", classes},
          {"--build-classes", classes, "--pose-classes", classes, "--classes", classes},
          {"--build-classes", classes, "--pose-classes", classes, "--matrix", path("m")}}) {
        std::vector<std::string> arguments = {"evaluate", "--index", index_file()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult refused = run(arguments);
        EXPECT_NE(refused.exit_status, 0);
        EXPECT_THAT(refused.err, HasSubstr("--build-classes"));
    }
}

TEST_F(CommandLineTest, ThinKeepsTopologyAndRefusesWhatIsNoVolume) {
    // A solid 3x3x9 bar inside a margin of one, as NumPy writes it.
    std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (11, 5, 5), }";
    header.resize(128 - 10 - 1, ' ');
    std::string bytes("\x93NUMPY\x01\x00\x76\x00", 10);
    bytes += header + "\n";
    for (int z = 0; z < 11; ++z) {
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 5; ++x) {
                const bool inside = z > 0 && z < 10 && y > 0 && y < 4 && x > 0 && x < 4;
                bytes.push_back(inside ? '\1' : '\0');
            }
        }
    }
    write_file(path("bar.npy"), bytes);
    for (const char* method : {"anchored", "parallel"}) {
        const nlohmann::json thinned =
            run({"thin", path("bar.npy"), path("thin.npy"), "--method", method, "--json"}).json();
        EXPECT_EQ(thinned.at("voxels_in"), 81) << method;
        EXPECT_GE(thinned.at("voxels_out").get<int>(), 1) << method;
        EXPECT_LE(thinned.at("voxels_out").get<int>(), 11) << method;
        EXPECT_EQ(thinned.at("betti_in"), thinned.at("betti_out")) << method;
    }
    write_file(path("bad.npy"), "not a volume");
    const ProgramResult bad = run({"thin", path("bad.npy"), path("out.npy")});
    EXPECT_EQ(bad.exit_status, 1);
    EXPECT_FALSE(std::filesystem::exists(path("out.npy")));
}

TEST_F(CommandLineTest, SkeletonWritesObjAndJsonAndRefusesOtherEndings) {
    const std::string model = model_files()[0];
    EXPECT_EQ(run({"skeleton", model, "--out", path("s.obj")}).exit_status, 0);
    EXPECT_THAT(read_file(path("s.obj")), HasSubstr("v "));
    const nlohmann::json refined = run({"skeleton", model, "--json"}).json();
    EXPECT_EQ(refined.at("stage"), "refined");
    EXPECT_TRUE(refined.contains("nodes"));
    EXPECT_TRUE(refined.contains("branches"));
    EXPECT_NE(run({"skeleton", model, "--out", path("s.gif")}).exit_status, 0);
    EXPECT_FALSE(std::filesystem::exists(path("s.gif")));
}

TEST_F(CommandLineTest, SegmentWritesMeshesThatAreIndexedAndFoundAgain) {
    ASSERT_EQ(build_index().exit_status, 0);
    const std::string model = model_files()[0];
    const std::string folder = path("written");
    std::filesystem::create_directory(folder);
    std::vector<std::string> command = {"segment", model};
    for (const char* extension : {"off", "obj", "ply", "stl"}) {
        command.insert(command.end(), {"--out", folder + "/parts_" + extension + "." + extension});
    }
    ASSERT_EQ(run(command).exit_status, 0);
    EXPECT_NE(run({"segment", model, "--out", path("parts.gif")}).exit_status, 0);
    const nlohmann::json indexed =
        run({"index", "--index", path("written.ossuary"), "--resolution", "24", "--json", folder})
            .json();
    EXPECT_EQ(indexed.at("failed"), 0);
    EXPECT_EQ(indexed.at("indexed"), 4);
    for (const char* extension : {"off", "obj", "ply", "stl"}) {
        const std::string query = folder + "/parts_" + extension + "." + extension;
        const nlohmann::json found =
            run({"search", "--index", index_file(), query, "--json"}).json();
        EXPECT_EQ(found.at("hits").at(0).at("name"), std::filesystem::path(model).stem().string());
        const nlohmann::json compared = run({"compare", model, query, "--json"}).json();
        EXPECT_LE(compared.at("distance").get<double>(), 0.02) << extension;
    }
}

TEST_F(CommandLineTest, RemoveTakesAllThatAreNamedOrNothing) {
    ASSERT_EQ(build_index().exit_status, 0);
    const std::string first = model_files()[0].stem();
    const auto count = [&] {
        return run({"models", "--index", index_file(), "--json"}).json().at("total").get<int>();
    };
    EXPECT_EQ(run({"remove", "--index", index_file(), first, "no-such-model"}).exit_status, 1);
    EXPECT_EQ(count(), kModels);
    EXPECT_EQ(run({"remove", "--index", index_file(), first}).exit_status, 0);
    EXPECT_EQ(count(), kModels - 1);
    EXPECT_EQ(run({"verify", "--index", index_file()}).exit_status, 0);
}

TEST_F(CommandLineTest, UpTurnsModelsAndSaysSo) {
    ASSERT_EQ(build_index().exit_status, 0);
    const std::string first = model_files()[0].stem(), second = model_files()[1].stem();
    const auto axis_of = [&](const std::string& model) {
        return run({"show", "--index", index_file(), model, "--json"}).json().at("up");
    };
    const ProgramResult turned = run({"up", "--index", index_file(), first, "#2", "z", "--json"});
    ASSERT_EQ(turned.exit_status, 0) << turned.err;
    EXPECT_EQ(turned.json().at("models").size(), 2);
    EXPECT_EQ(turned.json().at("models")[1].at("name"), second);
    EXPECT_EQ(axis_of(first), "z");
    EXPECT_EQ(axis_of(second), "z");
    EXPECT_THAT(run({"up", "--index", index_file(), first, "y"}).out, HasSubstr("y up"));
    EXPECT_EQ(axis_of(first), "y");
    EXPECT_EQ(run({"up", "--index", index_file(), first, "x"}).exit_status, 0);
    EXPECT_EQ(axis_of(first), "x");
    EXPECT_EQ(run({"up", "--index", index_file(), first, "auto"}).exit_status, 0);
    EXPECT_EQ(run({"up", "--index", index_file(), first, "w"}).exit_status, 2);
    EXPECT_EQ(run({"up", "--index", index_file(), first}).exit_status, 2);
    EXPECT_EQ(run({"up", "--index", index_file(), "no-such-model", "z"}).exit_status, 1);
    EXPECT_EQ(run({"verify", "--index", index_file()}).exit_status, 0);

    const ProgramResult all =
        run({"index", "--index", index_file(), "--up", "z", models(), "--json"});
    ASSERT_EQ(all.exit_status, 0) << all.err;
    EXPECT_EQ(all.json().at("unchanged"), kModels);
    EXPECT_GE(all.json().at("turned").get<int>(), kModels - 1);
    EXPECT_EQ(axis_of(first), "z");
    EXPECT_EQ(run({"index", "--index", index_file(), "--up", "w", models()}).exit_status, 2);
}

TEST_F(CommandLineTest, ExportPrintsOneJsonDocumentALine) {
    ASSERT_EQ(build_index().exit_status, 0);
    std::istringstream lines(run({"export", "--index", index_file()}).out);
    int documents = 0;
    for (std::string line; std::getline(lines, line); ++documents) {
        EXPECT_TRUE(nlohmann::json::parse(line).contains("skeleton"));
    }
    EXPECT_EQ(documents, kModels);
}

}  // namespace
}  // namespace ossuary::test
