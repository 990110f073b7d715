// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/chosenAssociator.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <stdexcept>

namespace monoslam::test
{
namespace
{
std::unique_ptr<Associator> choose(const std::string& ini)
{
    return chosenAssociator(mrpt::config::CConfigFileMemory(ini), "a.ini");
}
}  // namespace

TEST(ChosenAssociator, IsTheOneThatIsNamed)
{
    EXPECT_TRUE(choose("[association]\nstrategy = mhda\n")->traits().hypothesesBetweenFrames);
    EXPECT_FALSE(choose("")->traits().hypothesesBetweenFrames);
    EXPECT_THROW(choose("[association]\nstrategy = guess\n"), std::invalid_argument);
}

TEST(ChosenAssociator, ChecksTheSectionsOfTheOthersToo)
{
    EXPECT_THROW(choose("[association]\nstrategy = mhda\n[association.jcbb]\ntua = 1\n"),
                 std::invalid_argument);
    const auto sections = associationSections();
    EXPECT_EQ(sections.count("association"), 1);
    for (const auto& name : associatorNames()) EXPECT_EQ(sections.count("association." + name), 1);
}
}  // namespace monoslam::test
