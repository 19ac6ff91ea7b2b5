#include <gtest/gtest.h>
#include <stdlib.h>

#include "index/codec.h"
#include "index/store.h"
#include "tests/index/cli/run_program.h"
#include "tests/index/sample_index.h"
#include "tests/support/benchmark_data.h"

// What an index holds does not depend on the processor, as far as the C library's mathematics does
// not: glibc rounds some results another way where the processor has no fused multiply-add.
namespace ossuary::test {
namespace {

namespace fs = std::filesystem;

/// Programs started meanwhile take the C library for one on a processor without AVX2 and FMA.
class OldProcessor {
public:
    OldProcessor() { setenv(kName, "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F", 1); }
    ~OldProcessor() { unsetenv(kName); }
    OldProcessor(const OldProcessor&) = delete;
    OldProcessor& operator=(const OldProcessor&) = delete;

private:
    static constexpr const char* kName = "GLIBC_TUNABLES";
};

struct Described {
    std::vector<std::string> descriptors;
    std::vector<skeleton::SkeletonGraph> skeletons;
};

class SameBits : public ::testing::Test {
protected:
    [[nodiscard]] Described describe(const std::vector<std::string>& files,
                                     const std::string& index) const {
        const std::string path = folder_.path() / index;
        std::vector<std::string> arguments = {"index", "--index", path};
        arguments.insert(arguments.end(), files.begin(), files.end());
        const ProgramResult indexed = run_ossuary(arguments, folder_.path());
        EXPECT_EQ(indexed.exit_status, 0) << indexed.err;
        auto store = index::Store::open(path, index::Access::kReadOnly);
        EXPECT_TRUE(store.ok());
        if (!store.ok()) return {};
        Described described;
        const auto page = store->models();
        EXPECT_TRUE(page.ok());
        if (!page.ok()) return {};
        for (const index::ModelSummary& model : page->models) {
            const auto descriptor = store->descriptors(std::vector<index::ModelId>{model.id});
            const auto skeleton = store->skeleton(model.id);
            EXPECT_TRUE(descriptor.ok() && descriptor->size() == 1 && skeleton.ok());
            if (!descriptor.ok() || descriptor->size() != 1 || !skeleton.ok()) return {};
            const descriptor::ModelDescriptor& of_model = descriptor->front().descriptor;
            described.descriptors.push_back(index::encode_descriptor(of_model.skeleton) +
                                            index::encode_globals(of_model.globals) +
                                            index::encode_signature(of_model.signature));
            described.skeletons.push_back(skeleton->graph);
        }
        return described;
    }

    /// The descriptors to the last bit; the skeletons' coordinates, which no ranking reads, but for
    /// their last digits.
    void expect_same_on_an_old_processor(const std::vector<std::string>& files) const {
        const Described here = describe(files, "here.ossuary");
        const OldProcessor pretended;
        const Described there = describe(files, "there.ossuary");
        ASSERT_EQ(here.descriptors.size(), files.size());
        EXPECT_EQ(here.descriptors, there.descriptors);
        ASSERT_EQ(here.skeletons.size(), there.skeletons.size());
        for (std::size_t i = 0; i < here.skeletons.size(); ++i) {
            const auto &a = here.skeletons[i].branches, &b = there.skeletons[i].branches;
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t k = 0; k < a.size(); ++k) {
                ASSERT_EQ(a[k].points.size(), b[k].points.size());
                for (std::size_t p = 0; p < a[k].points.size(); ++p) {
                    EXPECT_TRUE(a[k].points[p].isApprox(b[k].points[p], 1e-12));
                }
            }
        }
    }

    TemporaryFolder folder_;
};

TEST_F(SameBits, OfBuiltModels) {
    write_sample_meshes(folder_.path() / "models", 5);
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder_.path() / "models")) {
        files.push_back(entry.path());
    }
    expect_same_on_an_old_processor(files);
}

TEST_F(SameBits, OfTenKindsOfRealModels) {
    OSSUARY_REQUIRE_BENCHMARK_DATA(data);
    std::vector<std::string> files;
    for (int number = 1; number < 380; number += 40) {
        files.push_back(data / "princeton-segmentation" / "off" /
                        (std::to_string(number) + ".off"));
    }
    expect_same_on_an_old_processor(files);
}

}  // namespace
}  // namespace ossuary::test
