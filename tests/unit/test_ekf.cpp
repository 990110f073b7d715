// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/ekf.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "monoslam_models/quaternion.h"
#include "randomBelief.h"

namespace monoslam
{
namespace
{
constexpr double kTolerance = 1e-9;
constexpr double kDt_s = 1.0 / 30.0;
const RandomBeliefOptions kMixed{8, 3, true};

/** diag(I, J_n, I, ...) of a normalisation of the camera's and the clones' quaternions. */
Eigen::MatrixXd normalizationJacobian(const Belief& belief, const Eigen::VectorXd& x)
{
    Eigen::MatrixXd J = Eigen::MatrixXd::Identity(x.size(), x.size());
    std::vector<Eigen::Index> offsets{3};
    for (const CloneSlot& slot : belief.clones) offsets.push_back(slot.offset + 3);
    for (const Eigen::Index offset : offsets)
    {
        Eigen::Matrix4d J_n_q;
        (void)normalizeQuaternion(x.segment<4>(offset), &J_n_q);
        J.block<4, 4>(offset, offset) = J_n_q;
    }
    return J;
}

Eigen::MatrixXd denseH(const Belief& belief, const Prediction& prediction)
{
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2 * prediction.count(), belief.size());
    for (Eigen::Index i = 0; i < prediction.count(); ++i)
    {
        const PredictedLandmark& row = prediction.rows[static_cast<std::size_t>(i)];
        H.block<2, 13>(2 * i, 0) = row.H_v;
        H.block(2 * i, row.offset, 2, row.size) = row.H_y.leftCols(row.size);
    }
    return H;
}

TEST(EkfPredict, MatchesTheDenseForm)
{
    std::mt19937 rng(1);
    const Camera camera;
    for (int trial = 0; trial < 20; ++trial)
    {
        const Belief prior = randomBelief(rng, camera, kMixed);
        const Belief posterior = ekfPredict(prior, {}, kDt_s);
        const MotionPrediction step = predictConstantVelocity(prior.camera(), kDt_s, {});
        Eigen::MatrixXd F = Eigen::MatrixXd::Identity(prior.size(), prior.size());
        F.topLeftCorner<13, 13>() = step.F;
        Eigen::MatrixXd P = F * prior.P * F.transpose();
        P.topLeftCorner<13, 13>() += step.Q;
        Eigen::VectorXd x = prior.x;
        x.head<13>() = step.x_v;
        Belief expected = prior;
        expected.clones.clear();  // only the camera's quaternion has moved
        const Eigen::MatrixXd J = normalizationJacobian(expected, x);
        x.segment<4>(3).normalize();
        EXPECT_LT(largestDifference(posterior.x, x), kTolerance);
        EXPECT_LT(largestDifference(posterior.P, J * P * J.transpose()), kTolerance);
        EXPECT_NO_THROW(posterior.checkInvariant());
    }
}

TEST(EkfPredict, RefusesTimeThatRunsBackwards)
{
    std::mt19937 rng(2);
    const Belief belief = randomBelief(rng, Camera(), {});
    EXPECT_THROW((void)ekfPredict(belief, {}, -1e-3), std::invalid_argument);
    EXPECT_THROW((void)ekfPredict(belief, {}, std::nan("")), std::invalid_argument);
}

TEST(PredictMeasurements, MatchesTheDenseForm)
{
    std::mt19937 rng(3);
    const Camera camera;
    const Belief belief = randomBelief(rng, camera, kMixed);
    const Prediction prediction = predictMeasurements(belief, camera, {8.0, 1.5});
    ASSERT_GT(prediction.count(), 8);
    const Eigen::MatrixXd H = denseH(belief, prediction);
    EXPECT_LT(largestDifference(prediction.PHt, belief.P * H.transpose()), kTolerance);
    EXPECT_LT(largestDifference(prediction.HPHt, H * belief.P * H.transpose()), 1e-6);
    for (Eigen::Index i = 0; i < prediction.count(); ++i)
    {
        const auto& row = prediction.rows[static_cast<std::size_t>(i)];
        const Eigen::Matrix2d HPHt = prediction.HPHt.block<2, 2>(2 * i, 2 * i);
        EXPECT_LT(largestDifference(row.S, HPHt + 2.25 * Eigen::Matrix2d::Identity()), 1e-6);
    }
}

TEST(EkfUpdate, MatchesTheJosephForm)
{
    std::mt19937 rng(4);
    const Camera camera;
    for (int trial = 0; trial < 20; ++trial)
    {
        const Belief prior = randomBelief(rng, camera, kMixed);
        const Prediction prediction = predictMeasurements(prior, camera, {});
        const auto pixels = randomPixels(rng, prediction);
        const Belief posterior = ekfUpdate(prior, prediction, pixels);

        const Eigen::MatrixXd H = denseH(prior, prediction);
        const Eigen::Index m = H.rows();
        Eigen::MatrixXd R = Eigen::MatrixXd::Zero(m, m);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            R.block<2, 2>(2 * static_cast<Eigen::Index>(i), 2 * static_cast<Eigen::Index>(i)) =
                pixels[i].R;
        const Eigen::MatrixXd S = H * prior.P * H.transpose() + R;
        const Eigen::MatrixXd K = prior.P * H.transpose() * S.inverse();
        const Eigen::MatrixXd I_KH = Eigen::MatrixXd::Identity(prior.size(), prior.size()) - K * H;
        Eigen::VectorXd x = prior.x + K * stackInnovation(prediction, pixels).nu;
        const Eigen::MatrixXd J = normalizationJacobian(prior, x);
        x.segment<4>(3).normalize();
        x.segment<4>(prior.clones[0].offset + 3).normalize();
        const Eigen::MatrixXd P =
            J * (I_KH * prior.P * I_KH.transpose() + K * R * K.transpose()) * J.transpose();
        EXPECT_LT(largestDifference(posterior.x, x), kTolerance);
        EXPECT_LT(largestDifference(posterior.P, P), kTolerance);
        EXPECT_LT(largestDifference(ekfUpdateMean(prior, prediction, pixels), x), kTolerance);
        EXPECT_NO_THROW(posterior.checkInvariant());
    }
}

TEST(EkfUpdate, DoesNotDependOnTheOrderOfThePixels)
{
    std::mt19937 rng(5);
    const Camera camera;
    const Belief prior = randomBelief(rng, camera, {});
    const Prediction prediction = predictMeasurements(prior, camera, {});
    auto pixels = randomPixels(rng, prediction);
    const Belief posterior = ekfUpdate(prior, prediction, pixels);
    std::reverse(pixels.begin(), pixels.end());
    const Belief reversed = ekfUpdate(prior, prediction, pixels);
    EXPECT_LT(largestDifference(posterior.x, reversed.x), kTolerance);
    EXPECT_LT(largestDifference(posterior.P, reversed.P), kTolerance);
}

TEST(EkfUpdate, ShrinksEveryVarianceAndKeepsPPositive)
{
    std::mt19937 rng(7);
    const Camera camera;
    Belief belief = randomBelief(rng, camera, kMixed);
    for (int frame = 0; frame < 50; ++frame)
    {
        const Prediction prediction = predictMeasurements(belief, camera, {});
        auto pixels = randomPixels(rng, prediction);
        for (PixelMeasurement& pixel : pixels)  // no innovation: the mean, and so F and H, stay
            pixel.z = prediction.rows[static_cast<std::size_t>(pixel.row)].h;
        const Belief posterior = ekfUpdate(belief, prediction, pixels);
        EXPECT_LE((posterior.P.diagonal() - belief.P.diagonal()).maxCoeff(), 1e-12);
        belief = ekfPredict(posterior, {}, 0.0);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(belief.P);
        EXPECT_GT(eigen.eigenvalues()[0], -1e-12);
    }
}

TEST(EkfUpdate, GivesTheSamePosteriorWhenTheWorldIsShifted)
{
    std::mt19937 rng(8);
    const Camera camera;
    const Belief prior = randomBelief(rng, camera, kMixed);
    const Eigen::Vector3d shift(3.0, -2.0, 1.0);
    const auto shifted = [&shift](Belief belief)
    {
        belief.x.head<3>() += shift;
        for (const auto& slot : belief.landmarks) belief.x.segment<3>(slot.offset) += shift;
        for (const auto& slot : belief.clones) belief.x.segment<3>(slot.offset) += shift;
        return belief;
    };
    const Prediction prediction = predictMeasurements(prior, camera, {});
    const auto pixels = randomPixels(rng, prediction);
    const Belief moved = shifted(prior);
    const Belief expected = shifted(ekfUpdate(prior, prediction, pixels));
    const Belief posterior = ekfUpdate(moved, predictMeasurements(moved, camera, {}), pixels);
    EXPECT_LT(largestDifference(posterior.x, expected.x), kTolerance);
    EXPECT_LT(largestDifference(posterior.P, expected.P), kTolerance);
}

TEST(EkfUpdate, CountsAnIndefiniteInnovationAndGivesUpWhenInflationDoesNotHelp)
{
    std::mt19937 rng(9);
    const Camera camera;
    const Belief prior = randomBelief(rng, camera, {});
    const Prediction prediction = predictMeasurements(prior, camera, {});
    auto pixels = randomPixels(rng, prediction);
    pixels[0].R = -1e6 * Eigen::Matrix2d::Identity();
    int faults = 0;
    EXPECT_THROW((void)ekfUpdate(prior, prediction, pixels, &faults), std::runtime_error);
    EXPECT_EQ(faults, 1);
}
}  // namespace
}  // namespace monoslam
