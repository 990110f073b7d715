// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <locale>
#include <stdexcept>

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
using mrpt::config::CConfigFileMemory;

enum class Colour
{
    Red,
    Green
};

const std::vector<std::pair<std::string, Colour>> kColours{{"red", Colour::Red},
                                                           {"green", Colour::Green}};

CConfigFileMemory fileWith(const std::string& lines)
{
    return CConfigFileMemory("[s]\n" + lines + "\n");
}

/** The message of the std::invalid_argument that the call throws, or what happened instead. */
template <typename Call>
std::string errorOf(const Call& call)
{
    try
    {
        call();
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "(no error)";
}

bool refusesNumber(const std::string& text)
{
    const CConfigFileMemory file = fileWith("a = " + text);
    ConfigSection section(file, "s");
    return errorOf([&] { (void)section.get("a", 1.0); }) != "(no error)";
}

bool refusesInteger(const std::string& text)
{
    const CConfigFileMemory file = fileWith("a = " + text);
    ConfigSection section(file, "s");
    return errorOf([&] { (void)section.get("a", 1); }) != "(no error)";
}

bool refusesList(const std::string& text)
{
    const CConfigFileMemory file = fileWith("a = " + text);
    ConfigSection section(file, "s");
    return errorOf([&] { (void)section.get("a", std::vector<double>{}); }) != "(no error)";
}
}  // namespace

TEST(ConfigSection, ReadsEveryType)
{
    const CConfigFileMemory file =
        fileWith("d = -1.5e2\ni = -7\nb = yes\nt = two words\nl = 1 2.5\nc = green");
    ConfigSection section(file, "s");
    EXPECT_EQ(section.get("d", 0.0), -150.0);
    EXPECT_EQ(section.get("i", 0), -7);
    EXPECT_TRUE(section.get("b", false));
    EXPECT_EQ(section.get("t", "none"), "two words");
    EXPECT_EQ(section.get("l", std::vector<double>{}), (std::vector<double>{1, 2.5}));
    EXPECT_EQ(section.get("c", Colour::Red, kColours), Colour::Green);
    EXPECT_NO_THROW(section.rejectUnknownKeys());
}

TEST(ConfigSection, KeepsTheFallbackOfAnAbsentKeyAndOfAnAbsentSection)
{
    const CConfigFileMemory file = fileWith("other = 1");
    for (const char* name : {"s", "absent"})
    {
        ConfigSection section(file, name);
        EXPECT_EQ(section.get("d", 2.5), 2.5);
        EXPECT_EQ(section.get("i", 3), 3);
        EXPECT_TRUE(section.get("b", true));
        EXPECT_EQ(section.get("t", std::string("none")), "none");
        EXPECT_EQ(section.get("l", std::vector<double>{4}), std::vector<double>{4});
        EXPECT_EQ(section.get("c", Colour::Green, kColours), Colour::Green);
        EXPECT_FALSE(section.has("d"));
    }
}

TEST(ConfigSection, RefusesWhatIsNotWhollyANumber)
{
    for (const char* text : {"abc", "1.5x", "1.5 2", "1,5", "", "nan", "inf", "1e999", "0.1.2"})
        EXPECT_TRUE(refusesNumber(text)) << text;
    for (const char* text : {"abc", "1.0", "1e3", "99999999999", "7 8", "", "0x"})
        EXPECT_TRUE(refusesInteger(text)) << text;
    for (const char* text : {"1 two", "[1 2", "1;2", "", "1 nan"})
        EXPECT_TRUE(refusesList(text)) << text;
    EXPECT_FALSE(refusesNumber("1.5"));
    EXPECT_FALSE(refusesInteger("-15"));
}

TEST(ConfigSection, TakesTheEndsOfARangeAndNothingBeyond)
{
    const CConfigFileMemory file = fileWith("low = 1\nhigh = 2\nbelow = 0.999\nabove = 3");
    ConfigSection section(file, "s");
    const Range range{1, 2};
    EXPECT_EQ(section.get("low", 0.0, range), 1.0);
    EXPECT_EQ(section.get("high", 0, range), 2);
    EXPECT_THROW((void)section.get("below", 1.0, range), std::invalid_argument);
    EXPECT_THROW((void)section.get("above", 1, range), std::invalid_argument);
    EXPECT_THROW((void)section.get("above", 1, Range{-5, 0}), std::invalid_argument);
}

TEST(ConfigSection, NamesFileSectionKeyAndValueOfAnError)
{
    const CConfigFileMemory file = fileWith("sigma_px = -2 // comment");
    ConfigSection section(file, "s", "desk.ini");
    const std::string error = errorOf([&] { (void)section.get("sigma_px", 1.0, kPositive); });
    EXPECT_EQ(error, "desk.ini: [s] sigma_px = -2: must be > 0");
}

TEST(ConfigSection, ReadsAllSpellingsOfABoolean)
{
    const CConfigFileMemory file =
        fileWith("t1=true\nt2=1\nt3=Yes\nf1=false\nf2=0\nf3=NO\nbad=maybe\nempty=");
    ConfigSection section(file, "s");
    for (const char* key : {"t1", "t2", "t3"}) EXPECT_TRUE(section.get(key, false)) << key;
    for (const char* key : {"f1", "f2", "f3"}) EXPECT_FALSE(section.get(key, true)) << key;
    EXPECT_THROW((void)section.get("bad", true), std::invalid_argument);
    EXPECT_THROW((void)section.get("empty", true), std::invalid_argument);
}

TEST(ConfigSection, ReadsListsWithSpacesCommasOrBrackets)
{
    const CConfigFileMemory file =
        fileWith("a = 1 -2.5 3e1\nb = 1, -2.5,30\nc = [ 1 -2.5, 30 ]\nempty = []\none = 4");
    ConfigSection section(file, "s");
    const std::vector<double> expected{1, -2.5, 30};
    for (const char* key : {"a", "b", "c"})
        EXPECT_EQ(section.get(key, std::vector<double>{9}), expected) << key;
    EXPECT_TRUE(section.get("empty", std::vector<double>{9}).empty());
    EXPECT_EQ(section.get("one", std::vector<double>{9}), std::vector<double>{4});
}

TEST(ConfigSection, ListsTheNamesWhenOneIsUnknown)
{
    const CConfigFileMemory file = fileWith("c = blue");
    ConfigSection section(file, "s");
    const std::string error = errorOf([&] { (void)section.get("c", Colour::Red, kColours); });
    EXPECT_EQ(error, "[s] c = blue: expected one of red, green");
}

TEST(ConfigSection, ListsUnknownKeysTogetherWithTheKnownOnes)
{
    const CConfigFileMemory file = fileWith("sigma = 1\nsigmo = 2\nzeta = 3");
    ConfigSection section(file, "s", "desk.ini");
    (void)section.get("sigma", 0.0);
    (void)section.get("alpha", 0.0);
    const std::string error = errorOf([&] { section.rejectUnknownKeys(); });
    EXPECT_EQ(error, "desk.ini: [s]: unknown keys: sigmo, zeta; known keys: alpha, sigma");
}

TEST(ConfigSection, IgnoresTheCaseOfKeysAsMrptDoes)
{
    const CConfigFileMemory file = fileWith("Sigma_PX = 3");
    ConfigSection section(file, "s");
    EXPECT_TRUE(section.has("sigma_px"));
    EXPECT_EQ(section.get("sigma_px", 0), 3);
    EXPECT_NO_THROW(section.rejectUnknownKeys());
}

TEST(ConfigSection, ReadsADecimalPointInEveryLocale)
{
    struct Comma : std::numpunct<char>
    {
        char do_decimal_point() const override { return ','; }
    };
    const CConfigFileMemory file = fileWith("d = 1.5\nl = 1.5 2.5");
    ConfigSection section(file, "s");
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const double number = section.get("d", 0.0);
    const std::vector<double> list = section.get("l", std::vector<double>{});
    std::locale::global(before);
    EXPECT_EQ(number, 1.5);
    EXPECT_EQ(list, (std::vector<double>{1.5, 2.5}));
}
}  // namespace monoslam
