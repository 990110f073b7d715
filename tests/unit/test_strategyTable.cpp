// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/strategyTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "associatorRuns.h"
#include "builtPlaces.h"

namespace monoslam::test
{
namespace
{
AssociatorTraits traitsOf(const std::string& name, const std::string& ini = {})
{
    return makeAssociator(name, mrpt::config::CConfigFileMemory("[association]\n" + ini))->traits();
}

/** Pixels, and fates, of two corrections. */
void expectSameChoices(const Correction& a, const Correction& b)
{
    for (const Association& record : a.associations)
    {
        EXPECT_EQ(record.fate, recordOf(b, record.id).fate) << record.id;
        EXPECT_EQ(record.z, recordOf(b, record.id).z) << record.id;
    }
}

/** Twenty landmarks, each with its right pixel and a worse-placed one. */
LinearWorld worldOfTwoCandidates(double scoreOfRight, double scoreOfWrong)
{
    LinearWorld world = LinearWorld::withLandmarks(20, 31);
    for (auto& [id, candidates] : world.seen)
    {
        candidates.front().score = scoreOfRight;
        const double angle = 2.4 * static_cast<double>(id);
        const Eigen::Vector2d off = 5.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        candidates.push_back({candidates.front().z + off, scoreOfWrong, world.R()});
        if (scoreOfWrong > scoreOfRight) std::swap(candidates[0], candidates[1]);
    }
    return world;
}

/** Known motion: an ellipse is small, and its centre right. */
LinearWorld pinned(LinearWorld world, const LinearWorld& reference)
{
    Eigen::Vector2d motion = Eigen::Vector2d::Zero();
    for (const auto& slot : reference.belief.landmarks)
        motion +=
            (reference.seen.at(slot.id).front().z - reference.belief.x.segment<2>(slot.offset)) /
            static_cast<double>(reference.belief.landmarks.size());
    world.belief.x.head<2>() = motion;
    world.belief.P.topLeftCorner(2, 2) = 25.0 * Eigen::Matrix2d::Identity();
    return world;
}

class Traits : public testing::TestWithParam<std::string>
{
};
}  // namespace

TEST_P(Traits, WithoutAppearanceScoresDoNotMatter)
{
    const LinearWorld right = worldOfTwoCandidates(0.95, 0.85);
    const LinearWorld good = pinned(right, right);
    const LinearWorld bad = pinned(worldOfTwoCandidates(0.85, 0.95), right);
    const std::string oneStage = "first_stage_landmarks = 0\n";
    if (traitsOf(GetParam()).appearance)
    {
        LinearWorld world = LinearWorld::withLandmarks(1, 12);
        const Eigen::Vector2d h = world.predict(world.belief).rows[0].h, apart(6.0, 0.0);
        const Candidate poor{h + apart, 0.72, world.R()}, fine{h - apart, 0.97, world.R()};
        world.seen[0] = {fine, poor};
        EXPECT_EQ(run(GetParam(), world).associations[0].z, fine.z);
        world.seen[0] = {{poor.z, fine.score, world.R()}, {fine.z, poor.score, world.R()}};
        EXPECT_EQ(run(GetParam(), world).associations[0].z, poor.z);
        return;
    }
    // One candidate each, of any score that is a candidate.
    LinearWorld one = LinearWorld::withLandmarks(20, 32), other = one;
    for (auto& [id, candidates] : other.seen)
        candidates.front().score = 0.99 - 0.005 * static_cast<double>(id);
    expectSameChoices(run(GetParam(), one), run(GetParam(), other));
    if (!traitsOf(GetParam(), oneStage).multipleCandidates) return;
    expectSameChoices(run(GetParam(), good, oneStage), run(GetParam(), bad, oneStage));
}

TEST_P(Traits, WithoutSpaceTheBestLookingCandidateInTheEllipseIsTaken)
{
    if (traitsOf(GetParam()).spatial) return;
    LinearWorld world = LinearWorld::withLandmarks(1, 12);
    const Eigen::Vector2d h = world.predict(world.belief).rows[0].h;
    const Eigen::Vector2d near = h + Eigen::Vector2d(1.0, 0.0), far = h - Eigen::Vector2d(9.0, 9.0);
    world.seen[0] = {{far, 0.95, world.R()}, {near, 0.85, world.R()}};
    EXPECT_EQ(run(GetParam(), world).associations[0].z, far);
}

TEST_P(Traits, CandidatesAndBeliefsAreAsSaid)
{
    const AssociatorTraits traits = traitsOf(GetParam());
    const LinearWorld world = LinearWorld::withLandmarks(8, 33);
    FrameView view = world.view();
    int most = 0;
    view.search = [&](const SearchRegion& region)
    {
        most = std::max(most, region.maxCandidates);
        return world.search(region);
    };
    std::mt19937 rng(1);
    const Correction correction =
        makeAssociator(GetParam(), mrpt::config::CConfigFileMemory(std::string()))
            ->correct({{world.belief, 0.0}}, view, rng);
    if (traits.multipleCandidates)
    {
        EXPECT_GT(most, 1);
    }
    EXPECT_EQ(correction.mixture.size() > 1, traits.hypothesesBetweenFrames);
}

INSTANTIATE_TEST_SUITE_P(All, Traits, testing::ValuesIn(associatorNames()),
                         [](const auto& tested) { return tested.param; });

TEST(StrategyTable, StandsInTheDocumentation)
{
    std::ifstream file(MONOSLAM_SOURCE_DIR "/libs/docs/strategies.md");
    std::ostringstream text;
    text << file.rdbuf();
    std::istringstream table(strategyTable());  // mono-slam adds rows of the libraries above
    for (std::string row; std::getline(table, row);)
        EXPECT_NE(text.str().find(row + "\n"), std::string::npos)
            << row << ": replace the table in libs/docs/strategies.md by what mono-slam "
            << "--list-strategies says";
}
}  // namespace monoslam::test
