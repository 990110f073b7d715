// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numeric>

#include "PerspectiveFrame.h"
#include "associatorRuns.h"
#include "monoslam_association/chooseSubset.h"
#include "monoslam_association/ellipseMass.h"
#include "monoslam_association/informationGain.h"

namespace monoslam::test
{
TEST(EllipseMass, EqualsASumOverAFineGrid)
{
    std::mt19937 rng(1);
    for (int i = 0; i < 40; ++i)
    {
        const Eigen::Matrix2d A = uniformVector<4>(rng, 3.0).reshaped(2, 2),
                              B = uniformVector<4>(rng, 3.0).reshaped(2, 2);
        const Eigen::Matrix2d C = A * A.transpose() + 0.2 * Eigen::Matrix2d::Identity();
        const Eigen::Matrix2d S = B * B.transpose() + 0.2 * Eigen::Matrix2d::Identity();
        const Eigen::Vector2d mean = uniformVector<2>(rng, 5.0);
        const double gate = 5.9915;
        const Eigen::Matrix2d precision = C.inverse(), region = S.inverse();
        const double step = 0.02;
        double sum = 0.0;
        const double u_px = std::sqrt(gate * S(0, 0)), v_px = std::sqrt(gate * S(1, 1));
        for (double u = -u_px; u <= u_px; u += step)
            for (double v = -v_px; v <= v_px; v += step)
            {
                const Eigen::Vector2d y(u, v);
                if (y.dot(region * y) >= gate) continue;
                sum += std::exp(-0.5 * (y - mean).dot(precision * (y - mean)));
            }
        sum *= step * step / (2.0 * M_PI * std::sqrt(C.determinant()));
        EXPECT_NEAR(ellipseMass(mean, C, S, gate), sum, 3e-3) << i;
    }
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    EXPECT_NEAR(ellipseMass({0.0, 0.0}, I, I, 5.991465), 0.95, 1e-4);
    EXPECT_EQ(ellipseMass({50.0, 0.0}, I, I, 5.9915), 0.0);
    EXPECT_NEAR(ellipseMass({0.0, 0.0}, 1e-6 * I, I, 5.9915), 1.0, 1e-4);
}

TEST(ChooseSubset, AddsTheLandmarkOfMostInformationGivenThoseBefore)
{
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        const PerspectiveFrame frame({8, 7, false, 0.5, 0.0, 0}, seed);
        Belief belief = frame.belief;
        const Prediction prediction = frame.view().predict(belief);
        std::vector<Eigen::Index> rows(static_cast<std::size_t>(prediction.count()));
        std::iota(rows.begin(), rows.end(), 0);
        const auto fast = chooseSubset(belief, prediction, rows, 5);
        // The slow form: H fixed, P conditioned in full.
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2 * prediction.count(), belief.size());
        for (const Eigen::Index i : rows)
        {
            const PredictedLandmark& row = prediction.rows[static_cast<std::size_t>(i)];
            H.block<2, 13>(2 * i, 0) = row.H_v;
            H.block(2 * i, row.offset, 2, row.size) = row.H_y.leftCols(row.size);
        }
        std::vector<Eigen::Index> slow;
        while (slow.size() < 5)
        {
            const PoseInformation information(belief.pose(), belief.P.topLeftCorner<7, 7>());
            Eigen::Index best = -1;
            double most = -1.0;
            for (const Eigen::Index i : rows)
            {
                if (std::find(slow.begin(), slow.end(), i) != slow.end()) continue;
                const Eigen::MatrixXd PHt = belief.P * H.middleRows<2>(2 * i).transpose();
                const Eigen::Matrix2d S =
                    H.middleRows<2>(2 * i) * PHt + prediction.rows[static_cast<std::size_t>(i)].R;
                const double bits = information(PHt.topRows<7>(), S);
                if (bits > most) most = bits, best = i;
            }
            slow.push_back(best);
            const Eigen::MatrixXd PHt = belief.P * H.middleRows<2>(2 * best).transpose();
            const Eigen::Matrix2d S =
                H.middleRows<2>(2 * best) * PHt + prediction.rows[static_cast<std::size_t>(best)].R;
            belief.P -= PHt * S.inverse() * PHt.transpose();
        }
        EXPECT_EQ(fast, slow) << seed;
    }
}

class ActivelyMatching : public testing::TestWithParam<const char*>
{
};

TEST_P(ActivelyMatching, TakesTheConsistentCandidateAmongClutter)
{
    int right = 0, wrong = 0, seen = 0, wrongOfNearest = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const PerspectiveFrame frame({12, 12, false, 0.5, 0.0, 1}, seed);
        const auto isRight = [&frame](const Association& record)
        { return record.z == frame.seen.at(record.id).front().z; };
        for (const Association& record : run(GetParam(), frame).associations)
        {
            ++seen;
            if (record.fate == Fate::Matched) ++(isRight(record) ? right : wrong);
        }
        const Correction nearest = run("spatial_nn", frame, "first_stage_landmarks = 0");
        for (const Association& record : nearest.associations)
            wrongOfNearest += record.fate == Fate::Matched && !isRight(record) ? 1 : 0;
    }
    EXPECT_GT(right, seen * 65 / 100);
    EXPECT_LT(wrong, seen * 10 / 100);
    EXPECT_LT(2 * wrong, wrongOfNearest);
}

TEST_P(ActivelyMatching, RejectsWhatTheOthersContradict)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 10);
    for (const LandmarkId id : {2, 9, 17, 28}) world.displace(id, {-9.0, 10.0});
    const Correction correction = run(GetParam(), world);
    for (const LandmarkId id : {2, 9, 17, 28})
        EXPECT_NE(recordOf(correction, id).fate, Fate::Matched) << id;
    EXPECT_GE(count(correction, Fate::Matched), 23);
}

INSTANTIATE_TEST_SUITE_P(All, ActivelyMatching,
                         testing::Values("active_matching", "clam", "subam"));

TEST(ActiveMatching, TakesBackAnEarlyMatchThatLaterOnesContradict)
{
    // Equal landmarks are measured by id, and the first has a wrong pixel only.
    int recovered = 0, fooled = 0;
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
        LinearWorld world = LinearWorld::withLandmarks(12, seed);
        for (const LandmarkId id : {0, 5, 9}) world.displace(id, {10.0, -8.0});
        const auto isGood = [&](const char* name)
        {
            const Correction c = run(name, world);
            long good = 0;
            for (const Association& record : c.associations)
                good +=
                    record.fate == Fate::Matched && record.id % 5 != 0 && record.id != 9 ? 1 : 0;
            return good >= 7;
        };
        recovered += isGood("active_matching") ? 1 : 0;
        fooled += isGood("active_search") ? 0 : 1;
    }
    EXPECT_GE(recovered, 15);
    EXPECT_GT(fooled, 30 - recovered);
}
}  // namespace monoslam::test
