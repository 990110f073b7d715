// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "PerspectiveFrame.h"
#include "associatorRuns.h"

namespace monoslam::test
{
namespace
{
constexpr const char* kOneStage =
    "gate_probability = 0.999999\nfirst_stage_landmarks = 0\nmax_iterations = 1\n";

/** The slow textbook form: dense gains, every match a hypothesis; all sets of the largest size. */
std::set<std::set<LandmarkId>> textbookConsensus(const PerspectiveFrame& frame, double threshold_px)
{
    const Prediction prediction = predictMeasurements(frame.belief, frame.camera, frame.visibility);
    std::set<std::set<LandmarkId>> best;
    for (const PredictedLandmark& row : prediction.rows)
    {
        if (frame.seen.count(row.id) == 0) continue;
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2, frame.belief.size());
        H.leftCols<13>() = row.H_v;
        H.middleCols(row.offset, row.size) = row.H_y.leftCols(row.size);
        const Eigen::Matrix2d S = H * frame.belief.P * H.transpose() + row.R;
        const Eigen::MatrixXd K = frame.belief.P * H.transpose() * S.inverse();
        Belief moved = frame.belief;
        moved.x += K * (frame.seen.at(row.id).front().z - row.h);
        moved.x.segment<4>(3).normalize();
        std::set<LandmarkId> inliers{row.id};
        for (const auto& other : predictMeasurements(moved, frame.camera, frame.visibility).rows)
            if (frame.seen.count(other.id) > 0 &&
                (frame.seen.at(other.id).front().z - other.h).norm() < threshold_px)
                inliers.insert(other.id);
        if (!best.empty() && inliers.size() > best.begin()->size()) best.clear();
        if (best.empty() || inliers.size() == best.begin()->size()) best.insert(inliers);
    }
    return best;
}

Correction runOn(const PerspectiveFrame& frame, const std::string& ini)
{
    return run("one_point_ransac", frame, kOneStage + ini);
}

std::set<LandmarkId> matched(const Correction& correction)
{
    std::set<LandmarkId> ids;
    for (const Association& record : correction.associations)
        if (record.fate == Fate::Matched) ids.insert(record.id);
    return ids;
}
}  // namespace

TEST(OnePointRansac, FindsTheTextbookConsensus)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        const PerspectiveFrame frame({15, 15, false, 0.5, 0.3, 0}, seed);
        const auto expected = textbookConsensus(frame, 2.0 * 0.5);
        // A rescue that rescues nothing leaves the low-innovation inliers alone.
        const Correction correction = runOn(frame, "[association.one_point_ransac]\ntau = 1e-6");
        EXPECT_EQ(expected.count(matched(correction)), 1) << seed;
        EXPECT_EQ(correction.counters.nodes, correction.counters.pairs);
    }
}

TEST(OnePointRansac, KeepsAllInliersAmongThirtyPerCentOutliers)
{
    constexpr int kFrames = 200;
    int complete = 0, accepted = 0, outliers = 0;
    for (unsigned seed = 1; seed <= kFrames; ++seed)
    {
        const PerspectiveFrame frame({25, 25, false, 0.5, 0.3, 0, true}, 1000 + seed);
        // At the default tau = 0.99 the gate alone would lose one of 35 inliers too often.
        const Correction correction = runOn(frame, "[association.one_point_ransac]\ntau = 0.999");
        bool all = true;
        for (const Association& record : correction.associations)
        {
            const bool isMatch = record.fate == Fate::Matched;
            const bool isWrong = frame.wrong.count(record.id) > 0;
            outliers += isWrong ? 1 : 0;
            accepted += isWrong && isMatch ? 1 : 0;
            // Noise of more than two standard deviations may be judged either way.
            const Eigen::Index index = frame.belief.find(record.id);
            const LandmarkSlot& slot = frame.belief.landmarks[static_cast<std::size_t>(index)];
            const auto there = linearizeLandmark(frame.truth, slot, frame.camera, frame.visibility);
            if (!isWrong && there && (record.z - there->h).norm() < 2.0 * 0.5) all &= isMatch;
        }
        complete += all ? 1 : 0;
    }
    EXPECT_GE(complete, kFrames * 99 / 100);
    EXPECT_LT(accepted, outliers / 15);
}

TEST(OnePointRansac, RescuesNearPointsOnlyWithTheNoiseInS)
{
    long with = 0, without = 0, right = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        const PerspectiveFrame frame({25, 25, false, 0.5, 0.3, 0}, seed);
        with += count(runOn(frame, ""), Fate::Matched);
        without += count(runOn(frame, "[association.one_point_ransac]\nrescue_without_R = true"),
                         Fate::Matched);
        right += static_cast<long>(frame.seen.size() - frame.wrong.size());
    }
    EXPECT_LT(without, with);
    EXPECT_GT(with, right * 85 / 100);
}

TEST(OnePointRansac, DrawsFewHypothesesWhenThereAreManyMatches)
{
    const PerspectiveFrame frame({30, 30, false, 0.5, 0.0, 0}, 3);
    const std::string section = "max_measured = 60\n[association.one_point_ransac]\n";
    const Correction all = runOn(frame, section + "enumerate_up_to = 60");
    const Correction drawn = runOn(frame, section + "enumerate_up_to = 0");
    EXPECT_EQ(all.counters.nodes, all.counters.pairs);
    EXPECT_LT(drawn.counters.nodes, all.counters.nodes);
    EXPECT_GE(count(drawn, Fate::Matched), count(all, Fate::Matched) - 3);
}

TEST(OnePointRansac, RefusesOptionsOutOfRange)
{
    const PerspectiveFrame frame({1, 1, false, 0.5, 0.0, 0}, 4);
    for (const char* bad : {"p = 1", "th_sigma = 0", "tau = 2", "rescue = true"})
        EXPECT_THROW(runOn(frame, std::string("[association.one_point_ransac]\n") + bad),
                     std::invalid_argument);
}
}  // namespace monoslam::test
