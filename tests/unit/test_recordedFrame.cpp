// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/RecordedFrame.h"

#include <gtest/gtest.h>

#include "associatorRuns.h"
#include "monoslam_association/recordedFrameFile.h"
#include "recordedFrames.h"

namespace monoslam::test
{
namespace
{
class FromFile : public testing::TestWithParam<std::string>
{
};
/** A strategy finds in the file what it found in the image only with the answers to its own searches. */
void expectAnswersMatter(const PerspectiveFrame& seen, const FrameView& image)
{
    const mrpt::config::CConfigFileMemory ini("[association]\nfirst_stage_landmarks = 0\n");
    const auto associator = makeAssociator("hohct", ini);
    const RecordedFrame wide = recordFrame(record(seen), image);
    const RecordedFrame frame = withAnswers(wide, image, *associator, std::mt19937(1));
    std::mt19937 rng(1);
    const Belief own = best(associator->correct(frame.mixture, image, rng).mixture);
    EXPECT_NE(own.x, best(associator->correct(frame.mixture, wide.view(), rng).mixture).x);
    EXPECT_EQ(own.x, best(associator->correct(frame.mixture, frame.view(), rng).mixture).x);
}

}  // namespace

TEST(RecordedFrame, FindsWhatTheFrameItselfFinds)
{
    const PerspectiveFrame seen({12, 8, false, 0.5, 0.2, 3, true}, 4);
    const RecordedFrame frame = record(seen);
    for (const char* name : {"hohct", "jcbb", "ccda", "active_search", "one_point_ransac", "mhda"})
    {
        const mrpt::config::CConfigFileMemory ini("");
        std::mt19937 a(1), b(1);
        const auto associator = makeAssociator(name, ini);
        const Correction own = associator->correct(frame.mixture, seen.view(), a);
        const Correction again = associator->correct(frame.mixture, frame.view(), b);
        EXPECT_EQ(best(own.mixture).x, best(again.mixture).x) << name;
    }
}

/** As an image does whose peak lies outside: its flank is the best there is in a smaller ellipse. */
TEST(RecordedFrame, KnowsWhatOnlyTheStrategysOwnEllipsesShowed)
{
    const PerspectiveFrame seen({12, 8, false, 0.5, 0.2, 3, true}, 4);
    FrameView image = seen.view();
    image.search = [search = image.search](const SearchRegion& region)
    {
        SearchResult found = search(region);
        if (region.gate > 10.0 || found.candidates.empty()) return found;
        found.candidates.front().z.x() += 0.5;
        found.candidates.front().score = 0.995;
        return found;
    };
    expectAnswersMatter(seen, image);
}

/** As a coarse search does that begins at other pixels in a smaller ellipse. */
TEST(RecordedFrame, LacksWhatTheStrategysOwnSearchMissed)
{
    const PerspectiveFrame seen({12, 8, false, 0.5, 0.2, 3, true}, 4);
    FrameView image = seen.view();
    image.search = [search = image.search](SearchRegion region)
    {
        const std::size_t most = static_cast<std::size_t>(region.maxCandidates);
        region.maxCandidates = 50;
        SearchResult found = search(region);
        if (region.gate <= 10.0 && found.candidates.size() > 1)
            found.candidates.erase(found.candidates.begin());
        if (found.candidates.size() > most) found.candidates.resize(most);
        return found;
    };
    expectAnswersMatter(seen, image);
}

TEST(RecordedFrame, GivesTheBestCandidatesOfARegionInOrder)
{
    RecordedFrame frame = exampleFrame();
    const Eigen::Matrix2d R = Eigen::Matrix2d::Identity();
    RecordedLandmark& landmark = frame.landmarks[2];
    landmark.candidates = {
        {{100.0, 50.0}, 0.9, R}, {{104.0, 50.0}, 0.8, R}, {{101.0, 51.0}, 0.6, R}};
    SearchRegion region{landmark.id, {100.0, 50.0}, R, 9.0, 5, {}};
    const FrameView view = frame.view();
    EXPECT_EQ(view.search(region).candidates.size(), 1U);  // of score 0.7 at least
    region.minScore = 0.5;
    ASSERT_EQ(view.search(region).candidates.size(), 2U);
    EXPECT_EQ(view.search(region).candidates[1].score, 0.6);
    EXPECT_NEAR(static_cast<double>(view.search(region).pixels), 9.0 * std::acos(-1.0), 0.5);
    region.gate = 25.0;
    region.maxCandidates = 2;
    EXPECT_EQ(view.search(region).candidates[1].score, 0.8);
    region.id = 12345;
    EXPECT_EQ(view.search(region).status, SearchStatus::Unpredictable);
}

TEST_P(FromFile, IsSolvedToTheSameBits)
{
    const RecordedFrame frame = exampleFrame();
    const RecordedFrame read = recordedFrameFromText(toText(frame), "bug.json");
    const mrpt::config::CConfigFileMemory ini("");
    std::mt19937 a(1), b(1);
    const auto associator = makeAssociator(GetParam(), ini);
    const Correction first = associator->correct(frame.mixture, frame.view(), a);
    const Correction second = associator->correct(read.mixture, read.view(), b);
    EXPECT_EQ(best(first.mixture).x, best(second.mixture).x);
    EXPECT_EQ(best(first.mixture).P, best(second.mixture).P);
    EXPECT_GT(count(first, Fate::Matched), 0);
}

INSTANTIATE_TEST_SUITE_P(All, FromFile, testing::ValuesIn(associatorNames()),
                         [](const auto& tested) { return tested.param; });
}  // namespace monoslam::test
