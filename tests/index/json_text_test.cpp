#include "index/json_text.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace ossuary::index {
namespace {

constexpr const char* kOdd = "\xEF\xBF\xBD";

TEST(JsonText, IsUtf8WhateverTheStringsHold) {
    nlohmann::json document;
    document["b\xE4r"] = "x\xF0\x9F";
    EXPECT_EQ(json_text(document), std::string("{\"b") + kOdd + "r\":\"x" + kOdd + "\"}");
    EXPECT_EQ(json_text(nlohmann::json({{"a", 1}}), 2), "{\n  \"a\": 1\n}");
    EXPECT_EQ(json_text(nlohmann::ordered_json({{"z", 1}, {"a", 2}})), R"({"z":1,"a":2})");
}

TEST(JsonText, HoldsNothingThatControlsATerminal) {
    const std::string hostile = "\x1B[2J\n\x7F\xC2\x9B\xE2\x80\xAE\xF3\xA0\x81\x81";
    const std::string text = json_text(nlohmann::json(hostile));
    EXPECT_EQ(text, R"("\u001b[2J\n\u007f\u009b\u202e\udb40\udc41")");
    EXPECT_EQ(nlohmann::json::parse(text), hostile);
}

/// One string of random bytes, mostly of those where UTF-8 is decided.
std::string random_bytes(std::mt19937_64& random) {
    static const std::string kBytes(
        "a\"\\\x80\x8F\x90\x9F\xA0\xBF\xC0\xC2\xC3\xE0\xE1\xE2\xED\xEF"
        "\xF0\xF1\xF4\xF5\xFF");
    std::string text(test::next_below(random, 12), '\0');
    for (char& c : text) c = kBytes[test::next_below(random, kBytes.size())];
    return text;
}

// Two programs read what we write: one that shows it, one that parses it. They see the same.
TEST(JsonText, AgreesWithValidUtf8OnEveryString) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 20000; ++i) {
        const std::string text = random_bytes(random);
        const auto parsed = nlohmann::json::parse(json_text(nlohmann::json(text)), nullptr, false);
        ASSERT_FALSE(parsed.is_discarded()) << terminal_text(text);
        EXPECT_EQ(parsed.get<std::string>(), valid_utf8(text)) << terminal_text(text);
        EXPECT_EQ(valid_utf8(valid_utf8(text)), valid_utf8(text));
        const std::string cut(cut_utf8(valid_utf8(text), 5));
        EXPECT_EQ(valid_utf8(cut), cut);
    }
}

}  // namespace
}  // namespace ossuary::index
