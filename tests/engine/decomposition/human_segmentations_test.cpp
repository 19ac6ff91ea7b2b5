#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "engine/decomposition/seg_file.h"
#include "engine/decomposition/segmentation_metrics.h"
#include "engine/mesh/read_mesh.h"
#include "tests/support/benchmark_data.h"

namespace ossuary::decomposition {
namespace {

namespace fs = std::filesystem;

/// Reads a .seg file without the code under test.
std::vector<std::uint32_t> raw_labels(const fs::path& path) {
    std::ifstream in(path);
    std::vector<std::uint32_t> labels;
    for (std::uint32_t label = 0; in >> label;) labels.push_back(label);
    return labels;
}

/// Independent of the code under test: sums over the pairs of labels that occur, in integers.
double rand_index_error_from_labels(const std::vector<std::uint32_t>& a,
                                    const std::vector<std::uint32_t>& b) {
    std::map<std::uint32_t, std::uint64_t> in_a, in_b;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> in_both;
    for (std::size_t face = 0; face < a.size(); ++face) {
        ++in_a[a[face]];
        ++in_b[b[face]];
        ++in_both[{a[face], b[face]}];
    }
    std::uint64_t together_a = 0, together_b = 0, together = 0;
    for (const auto& [label, n] : in_a) together_a += n * (n - 1) / 2;
    for (const auto& [label, n] : in_b) together_b += n * (n - 1) / 2;
    for (const auto& [label, n] : in_both) together += n * (n - 1) / 2;
    const std::uint64_t n = a.size();
    return static_cast<double>(together_a + together_b - 2 * together) /
           static_cast<double>(n * (n - 1) / 2);
}

TEST(HumanSegmentations, RandIndexErrorOfTwentyModelsIsThatOfTheSegFiles) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const fs::path folder = data / "princeton-segmentation";
    int models = 0;
    for (int model = 3; model <= 400 && models < 20; model += 19) {
        const std::string name = std::to_string(model);
        const auto mesh = mesh::read_mesh(folder / "off" / (name + ".off"));
        if (!mesh) continue;  // 261 to 280 are not part of the benchmark
        const std::size_t faces = mesh->mesh.face_count;
        const auto humans = read_segmentations(folder / "seg", name, faces);
        ASSERT_TRUE(humans.ok()) << humans.error().message;
        ASSERT_GE(humans->size(), 2u);
        const std::vector<double> areas(faces, 1.0);
        std::vector<fs::path> paths;
        for (const auto& entry : fs::directory_iterator(folder / "seg" / name)) {
            paths.push_back(entry.path());
        }
        std::sort(paths.begin(), paths.end());
        ASSERT_EQ(paths.size(), humans->size());
        for (std::size_t h = 1; h < paths.size(); ++h) {
            EXPECT_NEAR(segmentation_errors((*humans)[0], (*humans)[h], areas).rand_index_error,
                        rand_index_error_from_labels(raw_labels(paths[0]), raw_labels(paths[h])),
                        1e-12)
                << name << ", " << paths[h].filename();
        }
        ++models;
    }
    EXPECT_EQ(models, 20);
}

TEST(HumanSegmentations, PeopleDifferFromEachOtherByATenthOfThePairs) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    const fs::path folder = data / "princeton-segmentation";
    double sum = 0.0;
    int models = 0;
    for (int model = 1; model <= 400; ++model) {
        const std::string name = std::to_string(model);
        if (!fs::exists(folder / "seg" / name)) continue;
        const std::size_t faces = raw_labels(folder / "seg" / name / (name + "_0.seg")).size();
        const auto humans = read_segmentations(folder / "seg", name, faces);
        ASSERT_TRUE(humans.ok()) << humans.error().message;
        const std::vector<double> areas(faces, 1.0);
        double model_sum = 0.0;
        int pairs = 0;
        for (std::size_t i = 0; i < humans->size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                model_sum +=
                    segmentation_errors((*humans)[i], (*humans)[j], areas).rand_index_error;
                ++pairs;
            }
        }
        sum += model_sum / pairs;
        ++models;
    }
    EXPECT_EQ(models, 380);
    EXPECT_NEAR(sum / models, 0.103, 0.0005);
}

}  // namespace
}  // namespace ossuary::decomposition
