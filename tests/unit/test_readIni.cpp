// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_support/readIni.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <fstream>
#include <stdexcept>

#include "TemporaryFolder.h"

namespace monoslam::test
{
namespace
{
TEST(ReadIni, PutsSettingsOverTheFile)
{
    const TemporaryFolder folder;
    const std::string file = folder / "a.ini";
    std::ofstream(file) << "[one]\nkept = 1\nchanged = 2\n[a.b]\nkey = 3\n";
    mrpt::config::CConfigFileMemory ini;
    readIni(file, {"one.changed=5", "a.b.key=x=y", "new.key="}, ini);
    EXPECT_EQ(ini.read_string("one", "kept", ""), "1");
    EXPECT_EQ(ini.read_string("one", "changed", ""), "5");
    EXPECT_EQ(ini.read_string("a.b", "key", ""), "x=y");
}

TEST(ReadIni, NamesTheFileOrTheSettingThatIsWrong)
{
    const TemporaryFolder folder;
    const std::string file = folder / "a.ini";
    std::ofstream(file) << "[one]\n";
    mrpt::config::CConfigFileMemory ini;
    EXPECT_THROW(readIni(folder / "none.ini", {}, ini), std::runtime_error);
    for (const std::string setting : {"one.key", "key=1", ".key=1", "one.=1", "=1"}) try
        {
            readIni(file, {setting}, ini);
            ADD_FAILURE() << setting;
        }
        catch (const std::invalid_argument& error)
        {
            EXPECT_NE(std::string(error.what()).find(setting), std::string::npos);
        }
}

TEST(RejectUnknownSections, NamesThemAndTheKnownOnes)
{
    const mrpt::config::CConfigFileMemory ini("[one]\na = 1\n[twoo]\nb = 1\n");
    EXPECT_NO_THROW(rejectUnknownSections(ini, {"one", "twoo", "three"}, "a.ini"));
    try
    {
        rejectUnknownSections(ini, {"one", "two"}, "a.ini");
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_STREQ(error.what(), "a.ini: unknown section [twoo]; known: one two");
    }
}
}  // namespace
}  // namespace monoslam::test
