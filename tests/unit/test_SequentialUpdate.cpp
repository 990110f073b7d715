// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "PerspectiveFrame.h"
#include "monoslam_association/SequentialUpdate.h"

namespace monoslam::test
{
namespace
{
std::size_t indexOf(const SequentialUpdate& update, LandmarkId id)
{
    std::size_t i = 0;
    while (update.landmarks().at(i).slot.id != id) ++i;
    return i;
}
}  // namespace

TEST(SequentialUpdate, EqualsOneFullUpdateAfterTheOther)
{
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const PerspectiveFrame frame({8, 7, seed % 2 == 0, 0.5, 0.0, 0}, seed);
        const FrameView view = frame.view();
        Belief textbook = frame.belief;
        SequentialUpdate update(frame.belief, view);
        for (const auto& [id, candidates] : frame.seen)
        {
            const Candidate& seen = candidates.front();
            const Prediction prediction = view.predict(textbook);
            const auto row = std::find_if(prediction.rows.begin(), prediction.rows.end(),
                                          [&](const auto& r) { return r.id == id; });
            if (row == prediction.rows.end()) continue;
            const std::size_t i = indexOf(update, id);
            ASSERT_TRUE(update.linearize(i));
            const PredictedLandmark& fast = update.landmarks()[i].row;
            EXPECT_LT((fast.h - row->h).norm(), 1e-7);
            EXPECT_LT(largestDifference(fast.S, row->S), 1e-7 * row->S.norm());
            ASSERT_TRUE(update.correct(i, seen.z, seen.R));
            textbook = ekfUpdate(std::move(textbook), prediction,
                                 {{row - prediction.rows.begin(), seen.z, seen.R}});
        }
        const Belief result = std::move(update).finish();
        result.checkInvariant();
        // Clones are normalised once, at the end: a difference of the second order.
        const double tolerance = frame.belief.clones.empty() ? 1e-9 : 1e-5;
        EXPECT_LT(largestDifference(result.x, textbook.x), tolerance);
        EXPECT_LT(largestDifference(result.P, textbook.P), tolerance);
    }
}

TEST(SequentialUpdate, KnowsEveryOpenLandmarkFromTheCurrentMean)
{
    const PerspectiveFrame frame({15, 10, false, 0.5, 0.0, 0}, 20);
    const FrameView view = frame.view();
    SequentialUpdate update(frame.belief, view);
    for (int step = 0; step < 5; ++step)
    {
        const std::size_t i = update.open()[static_cast<std::size_t>(step)];
        const Candidate& seen = frame.seen.at(update.landmarks()[i].slot.id).front();
        ASSERT_TRUE(update.linearize(i));
        ASSERT_TRUE(update.correct(i, seen.z, seen.R));
    }
    SequentialUpdate copy = update;
    const Belief belief = std::move(copy).finish();
    const Prediction full = view.predict(belief);
    EXPECT_LT(largestDifference(update.cameraCovariance(), belief.P.topLeftCorner<13, 13>()), 1e-9);
    for (const std::size_t i : update.open())
    {
        const OpenLandmark& open = update.landmarks()[i];
        const auto row = std::find_if(full.rows.begin(), full.rows.end(),
                                      [&](const auto& r) { return r.id == open.slot.id; });
        ASSERT_NE(row, full.rows.end());
        EXPECT_LT((open.row.h - row->h).norm(), 0.1);  // moved linearly
        EXPECT_LT(largestDifference(open.row.S, row->S), 0.02 * row->S.norm());
        ASSERT_TRUE(update.linearize(i));
        EXPECT_LT((open.row.h - row->h).norm(), 1e-7);
        EXPECT_LT(largestDifference(open.row.S, row->S), 1e-7 * row->S.norm());
        const Eigen::MatrixXd C = full.PHt.block(0, 2 * (row - full.rows.begin()), 7, 2);
        EXPECT_LT(largestDifference(open.C, C), 1e-7);
    }
}

TEST(SequentialUpdate, LeavesTheBeliefAloneWithoutAPixelOrAnInvertibleS)
{
    const PerspectiveFrame frame({3, 3, true, 0.5, 0.0, 0}, 30);
    const FrameView view = frame.view();
    SequentialUpdate update(frame.belief, view);
    const std::size_t all = update.open().size();
    const std::size_t i = update.open().front();
    EXPECT_FALSE(update.correct(i, {320.0, 240.0}, -1e9 * Eigen::Matrix2d::Identity()));
    EXPECT_EQ(update.open().size(), all);
    update.close(i);
    EXPECT_EQ(update.open().size(), all - 1);
    const Belief result = std::move(update).finish();
    EXPECT_EQ(result.x, frame.belief.x);
    EXPECT_EQ(result.P, frame.belief.P);
}
}  // namespace monoslam::test
