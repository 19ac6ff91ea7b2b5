#include "server/multipart.h"

#include <gtest/gtest.h>

#include <string>

namespace ossuary::server {
namespace {

constexpr const char* kType = "multipart/form-data; boundary=xyz";

std::string part(std::string_view disposition, std::string_view content) {
    return "--xyz\r\nContent-Disposition: " + std::string(disposition) +
           "\r\nContent-Type: model/off\r\n\r\n" + std::string(content) + "\r\n";
}

TEST(Form, GivesPartsWithTheirNamesAndBytes) {
    using namespace std::string_literals;
    const std::string content = "OFF\r\n--xy\0\r\n--"s;
    const std::string body =
        part("form-data; name=\"model\"; filename=\"C:\\\\a/b\\\\cow.off\"", content) +
        part("form-data; name=x", "") + "--xyz--\r\n";
    const auto form = parse_form(kType, body);
    ASSERT_TRUE(form) << form.error().detail;
    ASSERT_EQ(form->size(), 2u);
    EXPECT_EQ((*form)[0].name, "model");
    EXPECT_EQ((*form)[0].file_name, "cow.off");
    EXPECT_EQ((*form)[0].content, content);
    EXPECT_EQ((*form)[1].name, "x");
    EXPECT_EQ((*form)[1].content, "");
}

TEST(Form, SkipsAPreamble) {
    const std::string body = "nothing\r\n" + part("form-data; name=\"model\"", "a") + "--xyz--";
    const auto form = parse_form("Multipart/Form-Data; boundary=\"xyz\"", body);
    ASSERT_TRUE(form);
    EXPECT_EQ(form->at(0).content, "a");
}

TEST(Form, RefusesWhatIsNotAForm) {
    const std::string good = part("form-data; name=\"model\"", "a");
    const auto refused = [](std::string_view type, std::string_view body) {
        const auto form = parse_form(type, body);
        return !form && form.error().row.code == "multipart_invalid";
    };
    EXPECT_TRUE(refused("multipart/form-data", good + "--xyz--"));
    EXPECT_TRUE(refused("multipart/form-data; boundary=", good + "--xyz--"));
    EXPECT_TRUE(refused("multipart/form-data; boundary=\"xyz", good + "--xyz--"));
    EXPECT_TRUE(refused(kType, ""));
    EXPECT_TRUE(refused(kType, "--xyz"));
    EXPECT_TRUE(refused(kType, good));
    EXPECT_TRUE(refused(kType, good + "--xyzz--"));
    EXPECT_TRUE(refused(kType, good.substr(0, 30)));
    EXPECT_TRUE(refused(kType, part("form-data", "a") + "--xyz--"));
    EXPECT_TRUE(refused(kType, part("attachment; name=\"model\"", "a") + "--xyz--"));
    EXPECT_TRUE(refused(kType, part("form-data; name=\"mo\x01\"", "a") + "--xyz--"));
    EXPECT_TRUE(refused(kType, part("form-data; name=\"mo\xff\"", "a") + "--xyz--"));
    EXPECT_TRUE(refused(kType, "--xyz\r\n" + std::string(10'000, 'a') + "\r\n\r\nx\r\n--xyz--"));
    std::string many;
    for (int i = 0; i < 33; ++i) many += good;
    EXPECT_TRUE(refused(kType, many + "--xyz--"));
}

TEST(Form, EveryPrefixOfAFormIsRefusedOrParsedWithoutOverrunningIt) {
    const std::string whole = part("form-data; name=\"model\"; filename=\"a\"", "abc") + "--xyz--";
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::string prefix = whole.substr(0, size);
        EXPECT_FALSE(parse_form(kType, prefix)) << size;
    }
    EXPECT_TRUE(parse_form(kType, whole));
}

}  // namespace
}  // namespace ossuary::server
