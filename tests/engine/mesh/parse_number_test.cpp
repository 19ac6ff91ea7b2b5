#include "engine/mesh/parse_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace ossuary::mesh {
namespace {

ParsedNumber<double> parse(const std::string& text) {
    return parse_double(text.data(), text.data() + text.size());
}

void expect_same_as_strtod(const std::string& text) {
    const ParsedNumber<double> number = parse(text);
    ASSERT_EQ(number.status, NumberStatus::kOk) << text;
    EXPECT_EQ(number.end, text.data() + text.size()) << text;
    const double expected = std::strtod(text.c_str(), nullptr);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(number.value), std::bit_cast<std::uint64_t>(expected))
        << text;
}

TEST(ParseDouble, RoundsEveryFiniteDoubleLikeTheCLibrary) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value) || std::abs(value) < 1e-300) continue;
        for (const char* format : {"%.17g", "%.9g", "%.6f", "%.3e", "%.19g"}) {
            char text[400];
            std::snprintf(text, sizeof text, format, value);
            expect_same_as_strtod(text);
        }
    }
}

TEST(ParseDouble, RoundsWhatModelFilesHoldLikeTheCLibrary) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 100'000; ++i) {
        const std::string sign = random() % 2 == 0 ? "-" : "";
        const std::string whole = std::to_string(random() % 1000);
        std::string fraction = std::to_string(random());
        fraction.resize(std::min<std::size_t>(fraction.size(), 1 + random() % 20));
        expect_same_as_strtod(sign + whole + "." + fraction);
    }
}

TEST(ParseDouble, RoundsHardCasesLikeTheCLibrary) {
    for (const char* text : {"9007199254740993",
                             "9007199254740992.5",
                             "9007199254740993.0000000000000000000001",
                             "0.1e-6",
                             "1e22",
                             "1e23",
                             "8.5e22",
                             "123456789012345678",
                             "0.30000000000000004",
                             "2.2250738585072012e-308",
                             "4.9406564584124654e-324",
                             "1.7976931348623157e308",
                             "00000000000000000000000000001.5",
                             "0.0000000000000000000000000000000000000015",
                             "-0",
                             "-0.0",
                             "5e-324",
                             "1.",
                             ".5",
                             "-.5",
                             "1e+5",
                             "1E-5"}) {
        expect_same_as_strtod(text);
    }
}

TEST(ParseDouble, GivesZeroForUnderflowAndRefusesOverflow) {
    for (const char* text : {"1e-400", "-1e-400", "0.0001e-99999", "1e-99999999999999999999"}) {
        EXPECT_EQ(parse(text).status, NumberStatus::kOk) << text;
        EXPECT_EQ(parse(text).value, 0.0) << text;
    }
    const std::string digits(400, '9');
    for (const std::string& text :
         {std::string("1e309"), std::string("-1e999"), digits,
          std::string("1e99999999999999999999"), "0.0001" + digits + "e400"}) {
        EXPECT_EQ(parse(text).status, NumberStatus::kNonFinite) << text;
    }
    EXPECT_EQ(parse("0." + std::string(400, '0') + "1e401").value, 1.0);
    EXPECT_EQ(parse("0e999").value, 0.0);
}

TEST(ParseDouble, NamesWhatIsNoFiniteNumber) {
    for (const char* text : {"nan", "-nan", "NaN", "inf", "-INF", "infinity", "+Infinity"}) {
        EXPECT_EQ(parse(text).status, NumberStatus::kNonFinite) << text;
    }
    for (const char* text : {"", "-", "+", ".", "-.", "e5", "--1", "+-1", "x", "#", " 1"}) {
        EXPECT_EQ(parse(text).status, NumberStatus::kNotANumber) << text;
    }
}

TEST(ParseDouble, StopsWhereTheNumberEnds) {
    const std::string text = "12.5,3";
    EXPECT_EQ(parse(text).end, text.data() + 4);
    const std::string hexadecimal = "0x10";
    EXPECT_EQ(parse(hexadecimal).end, hexadecimal.data() + 1);
}

}  // namespace
}  // namespace ossuary::mesh
