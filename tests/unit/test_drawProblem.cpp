// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/drawProblem.h"

#include <gtest/gtest.h>

#include "associatorRuns.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/recordedFrameFile.h"
#include "monoslam_eval/solveProblem.h"

namespace monoslam::test
{
namespace
{
long rightOnes(const RecordedFrame& frame)
{
    return std::count_if(frame.landmarks.begin(), frame.landmarks.end(),
                         [](const RecordedLandmark& landmark) { return *landmark.truth >= 0; });
}

Solution solutionOf(const RecordedFrame& frame, const std::string& name, const std::string& ini)
{
    const mrpt::config::CConfigFileMemory file("[association]\nfirst_stage_landmarks = 0\n" + ini);
    return solveProblem(*makeAssociator(name, file), frame, 1);
}
}  // namespace

TEST(DrawProblem, HasTheShapeThatIsAskedFor)
{
    for (const ProblemShape shape :
         {ProblemShape{1, 1, 0}, ProblemShape{6, 2, 3}, ProblemShape{50, 4, 10}})
    {
        const RecordedFrame frame = drawProblem(shape, 3);
        EXPECT_NO_THROW(frame.check());
        EXPECT_EQ(frame.landmarks.size(), static_cast<std::size_t>(shape.landmarks));
        EXPECT_EQ(rightOnes(frame), shape.landmarks - shape.absent);
        const double gate = chi2Limit(2, ProblemDistributions().gateProbability);
        for (const RecordedLandmark& landmark : frame.landmarks)
        {
            ASSERT_EQ(landmark.candidates.size(), static_cast<std::size_t>(shape.candidates));
            for (std::size_t c = 0; c < landmark.candidates.size(); ++c)
            {
                const Candidate& candidate = landmark.candidates[c];
                const Eigen::Vector2d nu = candidate.z - landmark.predicted->h;
                EXPECT_LT(nu.dot(landmark.predicted->S.inverse() * nu), gate);
                EXPECT_LE(candidate.score, c == 0 ? 1.0 : landmark.candidates[c - 1].score);
                EXPECT_GE(candidate.score, ProblemDistributions().minScore);
            }
        }
    }
}

TEST(DrawProblem, GivesTheSameBitsForTheSameSeedAndOthersForAnother)
{
    const ProblemShape shape{10, 2, 2};
    EXPECT_EQ(toText(drawProblem(shape, 5)), toText(drawProblem(shape, 5)));
    EXPECT_NE(toText(drawProblem(shape, 5)), toText(drawProblem(shape, 6)));
    EXPECT_NE(toText(drawProblem(shape, 5)).substr(0, 9000),
              toText(drawProblem({10, 2, 3}, 5)).substr(0, 9000));
}

/** Right pixels are as far from their predictions, jointly, as the belief says; a little nearer,
 *  because frames with a right pixel out of its ellipse are drawn anew. */
TEST(DrawProblem, IsConsistent)
{
    double sum = 0.0;
    const int runs = 200, m = 12;
    for (unsigned seed = 0; seed < runs; ++seed)
        sum += solutionOf(drawProblem({m, 1, 0}, seed), "none", {}).d2;
    EXPECT_GT(sum / (2.0 * m * runs), 0.9);
    EXPECT_LT(sum / (2.0 * m * runs), 1.05);
}

TEST(DrawProblem, HasScoresThatTellSomethingButNotAll)
{
    long right = 0, landmarks = 0;
    for (unsigned seed = 0; seed < 50; ++seed)
    {
        const Solution solution = solutionOf(drawProblem({12, 3, 0}, seed), "appearance_nn", {});
        right += solution.right;
        landmarks += solution.present;
    }
    EXPECT_GT(static_cast<double>(right), 0.7 * static_cast<double>(landmarks));
    EXPECT_LT(static_cast<double>(right), 0.95 * static_cast<double>(landmarks));
}

TEST(DrawProblem, RefusesShapesThatCannotBe)
{
    EXPECT_THROW(static_cast<void>(drawProblem({0, 1, 0}, 1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(drawProblem({5, 0, 0}, 1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(drawProblem({5, 1, 6}, 1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(drawProblem({5, 1, -1}, 1)), std::invalid_argument);
}

TEST(SolveProblem, CountsWhatIsRightAndWhatIsMissed)
{
    const RecordedFrame frame = drawProblem({20, 1, 4}, 9);
    const Solution none = solutionOf(frame, "none", {});
    EXPECT_EQ(none.accepted, 20);
    EXPECT_EQ(none.right, 16);
    EXPECT_EQ(none.present, 16);
    EXPECT_FALSE(none.jointlyCorrect());
    const Solution hohct = solutionOf(frame, "hohct", {});
    EXPECT_EQ(hohct.accepted + hohct.rejected, 20);
    EXPECT_GT(hohct.rejected, 0);
    EXPECT_GE(hohct.right, 15);
    EXPECT_NEAR(hohct.d2, hohct.correction.counters.jointD2, 1e-9 * (1.0 + hohct.d2));
    RecordedFrame without = frame;
    without.landmarks[3].truth.reset();
    const Solution unknown = solutionOf(without, "none", {});
    EXPECT_FALSE(unknown.truthKnown);
    EXPECT_EQ(unknown.right, 0);
}

TEST(SolveProblem, GivesEveryStrategySomethingToDo)
{
    const RecordedFrame frame = drawProblem({15, 2, 2}, 4);
    for (const std::string& name : associatorNames())
    {
        const Solution solution = solutionOf(frame, name, {});
        EXPECT_GT(solution.right, 5) << name;
        EXPECT_LE(solution.accepted + solution.rejected, 15) << name;
        EXPECT_GE(solution.total_ms, 0.0) << name;
    }
}

TEST(SolveProblem, TakesTheHeaviestBeliefForStrategiesOfOne)
{
    RecordedFrame frame = drawProblem({10, 1, 0}, 4);
    frame.mixture.push_back(drawProblem({10, 1, 0}, 5).mixture.front());
    frame.mixture.back().logWeight = -3.0;
    const Solution one = solutionOf(frame, "hohct", {});
    EXPECT_EQ(one.correction.mixture.size(), 1U);
    EXPECT_GE(one.right, 9);
    EXPECT_EQ(solutionOf(frame, "mhda", {}).correction.mixture.size(), 2U);
}
}  // namespace monoslam::test
