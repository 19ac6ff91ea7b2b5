#include "index/reader/three_mf_package.h"

#include <gtest/gtest.h>

#include "engine/core/whole_file.h"
#include "engine/mesh/measures.h"
#include "index/model_reader.h"
#include "index/reader/zip_archive.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_formats.h"

namespace ossuary::index {
namespace {

const std::string kModelType = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
const std::string kThumbnailType =
    "http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail";

std::string relation(const std::string& target, const std::string& type) {
    return "<Relationship Id=\"" + std::to_string(target.size()) + type.substr(type.size() - 3) +
           "\" Target=\"" + target + "\" Type=\"" + type + "\"/>";
}

std::string relations(const std::string& all) {
    return R"(<?xml version="1.0"?><Relationships )"
           R"(xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)" +
           all + "</Relationships>";
}

/// A package of these relations, with one model part.
std::string package(const std::string& root, const std::string& of_part = "") {
    const test::TemporaryFolder folder;
    std::vector<std::pair<std::string, std::string>> members = {
        {"[Content_Types].xml",
         R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
         R"(<Default Extension="rels" )"
         R"(ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
         R"(<Default Extension="png" ContentType="image/png"/><Default Extension="model" )"
         R"(ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
        {"_rels/.rels", relations(root)},
        {"3D/part.model",
         test::three_mf_part(test::three_mf_object(test::box_mesh(Vec3::Zero(), Vec3::Ones())),
                             R"(<item objectid="1"/>)")}};
    if (!of_part.empty()) members.emplace_back("3D/_rels/part.model.rels", relations(of_part));
    const auto bytes = read_whole_file(test::write_zip(folder.path() / "a.3mf", members));
    return std::string(bytes->view());
}

const std::string kModel = relation("/3D/part.model", kModelType);

std::string member(std::string_view package, const std::string& name) {
    const auto archive = ZipArchive::open(package);
    return *archive->read(*archive->find(name), 1 << 20);
}

TEST(ThreeMfPackage, IsLeftAloneWhereEachRelationIsOfTheModel) {
    EXPECT_FALSE(trim_package(package(kModel)));
    EXPECT_FALSE(trim_package(package(kModel, relation("/3D/gone.model", kModelType))));
    EXPECT_FALSE(trim_package("PK\3\4 and no archive"));
}

TEST(ThreeMfPackage, LosesTheRelationsOfItsRootToAnythingElse) {
    const auto trimmed = trim_package(
        package(relation("/Metadata/thumbnail.png", kThumbnailType) + kModel +
                relation("/3D/ticket.xml", "http://schemas.microsoft.com/2013/01/printticket")));
    ASSERT_TRUE(trimmed);
    EXPECT_EQ(trimmed->dropped, 2u);
    EXPECT_EQ(member(trimmed->bytes, "_rels/.rels"), relations(kModel));
}

TEST(ThreeMfPackage, LosesTheRelationsOfAPartToPrintTicketsAndToWhatIsNotThere) {
    const std::string here = relation("part.model", "http://a/texture");
    const auto trimmed =
        trim_package(package(kModel, here + relation("../gone.png", "http://a/texture") +
                                         relation("part.model", "http://a/printticket")));
    ASSERT_TRUE(trimmed);
    EXPECT_EQ(trimmed->dropped, 2u);
    EXPECT_EQ(member(trimmed->bytes, "3D/_rels/part.model.rels"), relations(here));
}

TEST(ThreeMfPackage, LosesARelationOnceThatBeginsWithinAnother) {
    const std::string within = "<Relationship Id=\"<Relationship \"/>";
    const auto trimmed = trim_package(package(within + kModel));
    ASSERT_TRUE(trimmed);
    EXPECT_EQ(trimmed->dropped, 1u);
    EXPECT_EQ(member(trimmed->bytes, "_rels/.rels"), relations(kModel));
}

TEST(ThreeMfPackage, IsReadWithoutTheThumbnailThatItNames) {
    ModelReader reader;
    const std::string bytes = package(kModel + relation("/Metadata/thumbnail.png", kThumbnailType));
    const auto read = reader.read({bytes, "a.3mf", {}});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->mesh.triangles.size(),
              test::box_mesh(Vec3::Zero(), Vec3::Ones()).triangles.size());
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_EQ(read->warnings[0].code, "relations_skipped");
}

}  // namespace
}  // namespace ossuary::index
