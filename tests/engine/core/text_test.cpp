#include "engine/core/text.h"

#include <gtest/gtest.h>

namespace ossuary {
namespace {

constexpr const char* kOdd = "\xEF\xBF\xBD";

std::string odd(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += kOdd;
    return text;
}

TEST(ValidUtf8, LeavesWellFormedTextAlone) {
    for (const char* text : {"", "elephant", "h\xC3\xA9ron", "\xE6\xA8\xA1\xE5\x9E\x8B",
                             "\xF0\x9F\x90\x98", "\xEE\x80\x80", "\xF4\x8F\xBF\xBF", "\xC2\x80",
                             "\xE0\xA0\x80", "\xED\x9F\xBF", "\xF0\x90\x80\x80"}) {
        EXPECT_EQ(valid_utf8(text), text);
    }
    EXPECT_EQ(valid_utf8(std::string_view("a\0b", 3)), std::string("a\0b", 3));
}

TEST(ValidUtf8, PutsOneMarkForEachMaximalSubpart) {
    EXPECT_EQ(valid_utf8("b\xE4r"), "b" + odd(1) + "r");             // Latin-1
    EXPECT_EQ(valid_utf8("\x80\xBF"), odd(2));                       // continuations alone
    EXPECT_EQ(valid_utf8("\xC0\xAF"), odd(2));                       // overlong solidus
    EXPECT_EQ(valid_utf8("\xE0\x80\xAF"), odd(3));                   // and in three bytes
    EXPECT_EQ(valid_utf8("\xF0\x80\x80\xAF"), odd(4));               // and in four
    EXPECT_EQ(valid_utf8("\xED\xA0\x80"), odd(3));                   // a surrogate
    EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80"), odd(4));               // above U+10FFFF
    EXPECT_EQ(valid_utf8("\xF5\xFE\xFF"), odd(3));                   // never bytes of UTF-8
    EXPECT_EQ(valid_utf8("a\xE2\x82"), "a" + odd(1));                // cut at the end
    EXPECT_EQ(valid_utf8("\xF0\x9F\x90z"), odd(1) + "z");            // cut in the middle
    EXPECT_EQ(valid_utf8("\xE2\x82\xC3\xA9"), odd(1) + "\xC3\xA9");  // what follows is whole
    EXPECT_EQ(valid_utf8("\x61\xF1\x80\x80\xE1\x80\xC2\x62\x80\x63\x80\xBF\x64"),  // the standard's
              "a" + odd(3) + "b" + odd(1) + "c" + odd(2) + "d");
}

TEST(CutUtf8, EndsBeforeTheCharacterThatDoesNotFit) {
    const std::string name = std::string(199, 'a') + "\xC3\xA9";
    EXPECT_EQ(cut_utf8(name, 200), std::string(199, 'a'));
    EXPECT_EQ(cut_utf8(name, 201), name);
    EXPECT_EQ(cut_utf8(std::string(198, 'a') + "\xF0\x9F\x90\x98" + "z", 201),
              std::string(198, 'a'));
    EXPECT_EQ(cut_utf8(std::string(300, 'b'), 200), std::string(200, 'b'));
    EXPECT_EQ(cut_utf8("\xF0\x9F\x90\x98", 3), "");
    EXPECT_EQ(cut_utf8("", 0), "");
}

TEST(TerminalText, EscapesWhatControlsATerminal) {
    EXPECT_EQ(terminal_text("\x1B[31mred\x1B[0m"), "\\x1b[31mred\\x1b[0m");
    EXPECT_EQ(terminal_text("a\nb\r\tc\x07\x7F"), "a\\nb\\r\\tc\\x07\\x7f");
    EXPECT_EQ(terminal_text("\xC2\x9B"
                            "31m"),
              "\\u009b31m");  // C1: CSI
    EXPECT_EQ(terminal_text("\x9B"
                            "31m"),
              "\\x9b31m");                                                     // the same as a byte
    EXPECT_EQ(terminal_text("gpj\xE2\x80\xAE.off"), "gpj\\u202e.off");         // override
    EXPECT_EQ(terminal_text("\xE2\x81\xA6x\xE2\x81\xA9"), "\\u2066x\\u2069");  // isolates
    EXPECT_EQ(terminal_text("\xE2\x80\xA8"), "\\u2028");                       // line separator
    EXPECT_EQ(terminal_text("b\xE4r"), "b\\xe4r");
    EXPECT_EQ(terminal_text("h\xC3\xA9ron \xF0\x9F\x90\x98"), "h\xC3\xA9ron \xF0\x9F\x90\x98");
    EXPECT_EQ(terminal_text(std::string_view("a\0b", 3)), "a\\x00b");
}

}  // namespace
}  // namespace ossuary
