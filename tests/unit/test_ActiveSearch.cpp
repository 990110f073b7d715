// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "PerspectiveFrame.h"
#include "associatorRuns.h"
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/informationGain.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam::test
{
namespace
{
constexpr double kStop_bits = 0.1;

struct Textbook
{
    Belief belief;
    std::vector<LandmarkId> order;
};

/** The slow form: everything predicted and updated in full at each step. */
Textbook textbook(const PerspectiveFrame& frame, bool aboutPose)
{
    const double gate = chi2Limit(2, BatchOptions().gate_probability);
    Textbook result{frame.belief, {}};
    std::set<LandmarkId> done;
    for (;;)
    {
        const Prediction all = frame.view().predict(result.belief);
        const PoseInformation pose(result.belief.pose(), result.belief.P.topLeftCorner<7, 7>());
        Eigen::Index best = -1;
        double mostPerArea = 0.0;
        for (Eigen::Index i = 0; i < all.count(); ++i)
        {
            const PredictedLandmark& row = all.rows[static_cast<std::size_t>(i)];
            const double bits = aboutPose ? pose(all.PHt.block<7, 2>(0, 2 * i), row.S)
                                          : informationAboutState(row.S, row.R);
            const double perArea = bits / (M_PI * gate * std::sqrt(row.S.determinant()));
            if (done.count(row.id) || bits < kStop_bits || perArea <= mostPerArea) continue;
            mostPerArea = perArea;
            best = i;
        }
        if (best < 0) return result;
        const PredictedLandmark& row = all.rows[static_cast<std::size_t>(best)];
        done.insert(row.id);
        result.order.push_back(row.id);
        SearchRegion region;
        region.id = row.id;
        region.centre = row.h;
        region.S = row.S;
        region.gate = gate;
        for (const Candidate& seen : frame.search(region).candidates)
            result.belief = ekfUpdate(std::move(result.belief), all, {{best, seen.z, seen.R}});
    }
}

/** A view that notes which landmarks are searched. */
FrameView noting(const PerspectiveFrame& frame, std::vector<LandmarkId>& order)
{
    FrameView view = frame.view();
    view.search = [&frame, &order](const SearchRegion& region)
    {
        order.push_back(region.id);
        return frame.search(region);
    };
    return view;
}
}  // namespace

TEST(ActiveSearch, MeasuresInTheOrderOfTheTextbookFormAndEndsWithItsBelief)
{
    for (const bool aboutPose : {false, true})
        for (unsigned seed = 1; seed <= 6; ++seed)
        {
            const PerspectiveFrame frame({8, 8, false, 0.5, 0.1, 0}, seed);
            const Textbook expected = textbook(frame, aboutPose);
            const mrpt::config::CConfigFileMemory file(
                std::string("[association.active_search]\nmi_target = ") +
                (aboutPose ? "pose" : "state"));
            std::vector<LandmarkId> order;
            std::mt19937 rng(1);
            const Correction correction =
                makeAssociator("active_search", file)
                    ->correct({{frame.belief, 0.0}}, noting(frame, order), rng);
            ASSERT_EQ(order, expected.order) << aboutPose << seed;
            EXPECT_LT(largestDifference(best(correction.mixture).x, expected.belief.x), 1e-8);
            EXPECT_LT(largestDifference(best(correction.mixture).P, expected.belief.P), 1e-8);
        }
}

TEST(ActiveSearch, StopsWhenNothingTellsEnough)
{
    const PerspectiveFrame frame({20, 20, false, 0.5, 0.0, 0}, 7);
    std::vector<long> searches;
    for (const char* bits : {"0", "1", "2", "3", "4", "6", "8", "1000"})
        searches.push_back(run("active_search", frame,
                               std::string("[association.active_search]\nstop_bits = ") + bits)
                               .counters.searches);
    EXPECT_TRUE(std::is_sorted(searches.rbegin(), searches.rend()));
    EXPECT_EQ(searches.front(), static_cast<long>(frame.seen.size()));
    EXPECT_EQ(searches.back(), 0);
    EXPECT_GE(std::set<long>(searches.begin(), searches.end()).size(), 3);
}

TEST(ActiveSearch, SearchesLessThanOneStageOfAllEllipses)
{
    const PerspectiveFrame frame({20, 20, false, 0.5, 0.0, 0}, 8);
    const Correction all = run("appearance_nn", frame, "first_stage_landmarks = 0");
    const Correction active = run("active_search", frame);
    double areaAll = 0.0, areaActive = 0.0;
    for (const Association& r : all.associations) areaAll += std::sqrt(r.S.determinant());
    for (const Association& r : active.associations)
        areaActive += r.fate == Fate::NotSearched ? 0.0 : std::sqrt(r.S.determinant());
    EXPECT_LT(areaActive, 0.3 * areaAll);
}

TEST(ActiveSearch, NeverGivesOnePixelTwice)
{
    LinearWorld world = LinearWorld::withLandmarks(2, 9);
    world.belief.x.segment<2>(world.belief.landmarks[1].offset) =
        world.belief.x.segment<2>(world.belief.landmarks[0].offset);
    world.seen[1] = world.seen[0];
    const Correction correction = run("active_search", world);
    EXPECT_EQ(count(correction, Fate::Matched), 1);
    EXPECT_EQ(count(correction, Fate::Rejected), 1);
}
}  // namespace monoslam::test
