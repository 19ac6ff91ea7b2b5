#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <sstream>

#include "index/cli/console.h"
#include "tests/index/cli/run_program.h"
#include "tests/index/sample_index.h"

// File systems give files any name. None stops a command, and none reaches a terminal raw.
namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kOdd = "\xEF\xBF\xBD";
const std::string kLatin = "b\xE4r";
const std::string kEscape = "x\x1B[31m\nossuary: internal: forged";
const std::string kTurned =
    "\xE2\x80\xAEgpj\xC2\x9B"
    "1m";
const std::string kLong = std::string(199, 'a') + "\xC3\xA9";
const std::string kMarkup = "<b>&\"'";
/// In the order of their bytes, which is that of their ids.
const std::vector<std::string> kNames = {kMarkup, kLong, kLatin, kEscape, kTurned};

bool is_printable(const std::string& text) { return cli::terminal_lines(text) == text; }

class OddNames : public ::testing::Test {
protected:
    void SetUp() override {
        write_sample_meshes(folder_.path() / "plain", 5);
        fs::create_directory(folder_.path() / "models");
        std::string classes = "PSB 1\n2 5\n\nk\xE4nguru 0 3\n";
        int next = 0;
        for (const auto& entry : sorted(folder_.path() / "plain")) {
            fs::rename(entry, models() / (kNames[static_cast<std::size_t>(next++)] + ".off"));
        }
        classes +=
            kLatin + "\n" + kLong + "\n" + kMarkup + "\n\nother 0 2\n" + kTurned + "\nzebra\n";
        write_file(folder_.path() / "odd.cla", classes);
    }
    static std::vector<fs::path> sorted(const fs::path& folder) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        return files;
    }
    [[nodiscard]] fs::path models() const { return folder_.path() / "models"; }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
    [[nodiscard]] std::string index_file() const { return path("some.ossuary"); }
    [[nodiscard]] std::string model(const std::string& name) const {
        return models() / (name + ".off");
    }
    ProgramResult run(const std::vector<std::string>& arguments, int expected_status) {
        ProgramResult result = run_ossuary(arguments, folder_.path());
        EXPECT_EQ(result.exit_status, expected_status) << arguments[0] << ": " << result.err;
        EXPECT_TRUE(is_printable(result.out)) << arguments[0] << ": " << result.out;
        EXPECT_TRUE(is_printable(result.err)) << arguments[0] << ": " << result.err;
        return result;
    }
    void build_index() {
        run({"index", "--index", index_file(), "--resolution", "24", "--classes", path("odd.cla"),
             models()},
            0);
    }

    TemporaryFolder folder_;
};

TEST_F(OddNames, AreShownEscapedByEveryCommand) {
    build_index();
    const ProgramResult list = run({"models", "--index", index_file()}, 0);
    EXPECT_THAT(list.out, HasSubstr("b\\xe4r"));
    EXPECT_THAT(list.out, HasSubstr("x\\x1b[31m\\nossuary"));
    EXPECT_THAT(list.out, HasSubstr("\\u202egpj\\u009b1m"));
    EXPECT_THAT(list.out, HasSubstr("k\\xe4nguru"));
    for (const std::string& name : kNames) {
        run({"show", "--index", index_file(), name}, 0);
        run({"search", "--index", index_file(), model(name)}, 0);
        run({"segment", model(name)}, 0);
        run({"skeleton", model(name), "--resolution", "24"}, 0);
        run({"compare", model(name), model(kLatin), "--resolution", "24"}, 0);
    }
    run({"evaluate", "--index", index_file(), "--out", path("report")}, 0);
    run({"verify", "--index", index_file()}, 0);
    run({"remove", "--index", index_file(), kEscape}, 0);
}

TEST_F(OddNames, AreShownEscapedInErrors) {
    for (const std::string& name : kNames) write_file(model(name), "OFF\n3 1 0\n0 0 0\n");
    run({"index", "--index", index_file(), "--resolution", "24", models()}, 3);
    run({"show", "--index", index_file()}, 0);
    for (const std::string& name : kNames) {
        run({"show", "--index", index_file(), name + "?"}, 1);
        run({"skeleton", path(name)}, 1);
        run({"skeleton", path(name), "--json"}, 1);
        run({"--" + name}, 2);
        run({"skeleton", path("x.off"), "--stage", name}, 2);
        run({name}, 2);
        run({"models", "--index", path(name)}, 4);
    }
}

TEST_F(OddNames, AreUtf8InJson) {
    build_index();
    const nlohmann::json list = run({"models", "--index", index_file(), "--json"}, 0).json();
    ASSERT_EQ(list.at("models").size(), kNames.size());
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        EXPECT_EQ(list.at("models")[i].at("name"), valid_utf8(kNames[i]));
        const std::string path_text = list.at("models")[i].at("path");
        EXPECT_EQ(path_text, valid_utf8(model(kNames[i])));
    }
    EXPECT_EQ(list.at("models")[2].at("class"), "k" + kOdd + "nguru");
    const nlohmann::json evaluation =
        run({"evaluate", "--index", index_file(), "--classes", path("odd.cla"), "--json"}, 0)
            .json();
    EXPECT_TRUE(evaluation.at("per_class").contains("k" + kOdd + "nguru"));
    for (const std::string& name : kNames) {
        const nlohmann::json found =
            run({"search", "--index", index_file(), model(name), "--json"}, 0).json();
        EXPECT_EQ(found.at("query").at("name"), valid_utf8(name));
        EXPECT_EQ(found.at("hits")[0].at("name"), valid_utf8(name));
    }
}

TEST_F(OddNames, StandInFilesAsUtf8) {
    for (const std::string& name : kNames) {
        run({"skeleton", model(name), "--resolution", "24", "--out", path("s.json")}, 0);
        EXPECT_EQ(nlohmann::json::parse(read_file(path("s.json"))).at("name"), valid_utf8(name));
        const std::string glb = path(name + ".glb");
        run({"segment", model(name), "--out", glb}, 0);
        const std::string bytes = read_file(glb);
        std::uint32_t length = 0;
        ASSERT_GT(bytes.size(), 20U) << name;
        std::memcpy(&length, bytes.data() + 12, sizeof length);
        const nlohmann::json document = nlohmann::json::parse(bytes.substr(20, length));
        const auto& nodes = document.at("nodes");
        const auto with_mesh =
            std::ranges::find_if(nodes, [](const auto& node) { return node.contains("mesh"); });
        ASSERT_NE(with_mesh, nodes.end()) << name;
        EXPECT_EQ(with_mesh->at("name"), valid_utf8(name));
    }
    build_index();
    run({"evaluate", "--index", index_file(), "--out", path("report")}, 0);
    for (const fs::path& file : sorted(path("report"))) {
        const std::string text = read_file(file);
        EXPECT_EQ(valid_utf8(text), text) << file;
        EXPECT_THAT(text, Not(HasSubstr("\x1B"))) << file;
        EXPECT_THAT(text, Not(HasSubstr(kMarkup))) << file;
    }
}

TEST_F(OddNames, AreFoundAsTheyAreShownToo) {
    build_index();
    for (const char* shown : {"b\\xe4r", "b\xEF\xBF\xBDr", "b\xE4r"}) {
        const ProgramResult found = run({"show", "--index", index_file(), "--json", shown}, 0);
        EXPECT_EQ(found.json().at("id"), 3) << shown;
    }
}

TEST_F(OddNames, AreExportedAll) {
    fs::create_directory(models() / "sub");
    fs::copy_file(model(kLatin), models() / "sub" / (kLatin + ".off"));  // two of one name
    fs::copy_file(model(kLong), models() / "#1.off");                    // named like an id
    build_index();
    const ProgramResult lines = run({"export", "--index", index_file()}, 0);
    std::istringstream text(lines.out);
    std::set<std::string> names;
    std::size_t documents = 0;
    for (std::string line; std::getline(text, line); ++documents) {
        names.insert(nlohmann::json::parse(line).at("name").get<std::string>());
    }
    EXPECT_EQ(documents, kNames.size() + 2);
    EXPECT_EQ(names.size(), kNames.size() + 1);

    const nlohmann::json summary =
        run({"export", "--index", index_file(), "--out", path("out"), "--json"}, 0).json();
    EXPECT_EQ(summary.at("written"), kNames.size() + 2);
    EXPECT_TRUE(summary.at("failures").empty());
    EXPECT_EQ(sorted(path("out")).size(), 4 * (kNames.size() + 2));
    for (const fs::path& file : sorted(path("out"))) {
        EXPECT_THAT(file.stem().string(), ::testing::MatchesRegex("[0-9]+")) << file;
        if (file.extension() != ".json") continue;
        EXPECT_TRUE(nlohmann::json::accept(read_file(file))) << file;
    }
}

TEST_F(OddNames, ExportGoesOnPastAModelThatIsDamaged) {
    build_index();
    execute_sql(index_file(), "UPDATE skeletons SET skeleton = x'00' WHERE model = 2;");
    const ProgramResult lines = run({"export", "--index", index_file()}, 3);
    EXPECT_EQ(std::count(lines.out.begin(), lines.out.end(), '\n'), 4);
    EXPECT_THAT(lines.err, HasSubstr("index_corrupt"));
    EXPECT_THAT(lines.err, HasSubstr("model 2"));

    execute_sql(index_file(), "DELETE FROM thumbnails WHERE model = 3;");  // none could be drawn
    fs::create_directories(path("out/4.off"));                             // in the way
    const ProgramResult files =
        run({"export", "--index", index_file(), "--out", path("out"), "--json"}, 3);
    const nlohmann::json summary = files.json();
    EXPECT_EQ(summary.at("written"), 3);
    ASSERT_EQ(summary.at("failures").size(), 2);
    EXPECT_EQ(summary.at("failures")[0].at("id"), 2);
    EXPECT_EQ(summary.at("failures")[0].at("code"), "index_corrupt");
    EXPECT_EQ(summary.at("failures")[1].at("code"), "file_unwritable");
    EXPECT_TRUE(fs::exists(path("out/5.png")));
    EXPECT_FALSE(fs::exists(path("out/3.png")));
    EXPECT_TRUE(fs::exists(path("out/3.off")));
}

}  // namespace
}  // namespace ossuary::test
