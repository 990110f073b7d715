// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/smoothWindow.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
constexpr int kViews = 7;
constexpr int kLandmarks = 30;
constexpr double kFixed = 1e12;
constexpr double kScaleSigma = 1e-3;

Eigen::Matrix<double, 6, 1> poseDifference(const Vector7d& truth, const Vector7d& estimate)
{
    Eigen::Matrix<double, 6, 1> d;
    d.head<3>() = estimate.head<3>() - truth.head<3>();
    d.tail<3>() =
        quaternionLog(quaternionProduct(quaternionConjugate(truth.tail<4>()), estimate.tail<4>()));
    return d;
}

/** A camera on an arc that looks at points 0.6 to 1.5 m ahead; exact pixels of weight R. */
Window trueWindow(const Camera& camera, double sigma_px)
{
    std::mt19937 rng(1);
    Window window;
    for (int k = 0; k < kViews; ++k)
    {
        Vector7d pose;
        pose << 0.05 * k, 0.01 * k * k, 0.02 * std::sin(k),
            quaternionExp(Eigen::Vector3d(0.02 * k, -0.04 * k, 0.01 * k));
        window.poses.push_back(pose);
    }
    for (int i = 0; i < kLandmarks; ++i)
    {
        const double depth = uniform(rng, 0.6, 1.5);
        const Eigen::Vector3d p_w =
            depth * Eigen::Vector3d(uniform(rng, -0.3, 0.5), uniform(rng, -0.3, 0.4), 1.0);
        WindowLandmark landmark;
        if (i % 3 == 0)
        {
            landmark.kind = LandmarkKind::Point;
            landmark.y = p_w;
        }
        else
        {
            Vector6d y;
            y << window.poses.front().head<3>(), rayAngles(p_w), 1.0 / p_w.norm();
            landmark.y = y;
        }
        window.landmarks.push_back(landmark);
        for (int k = 0; k < kViews; ++k)
        {
            Vector13d x_v = Vector13d::Zero();
            x_v.head<7>() = window.poses[static_cast<std::size_t>(k)];
            const auto uv = projectPixel(camera, x_v, landmark.kind, landmark.y);
            if (uv && camera.contains(*uv))
                window.observations.push_back(
                    {k, i, *uv, sigma_px * sigma_px * Eigen::Matrix2d::Identity()});
        }
    }
    window.firstPoseInformation = kFixed * Eigen::Matrix<double, 6, 6>::Identity();
    window.scaleSigma = kScaleSigma;
    return window;
}

/** Moves everything but the first pose and the last position, which hold the gauge. */
Window perturbed(Window window, double sigma_r, double sigma_theta, double relative,
                 std::mt19937& rng)
{
    for (std::size_t k = 1; k < window.poses.size(); ++k)
    {
        Vector7d& pose = window.poses[k];
        if (k + 1 < window.poses.size()) pose.head<3>() += normalVector<3>(rng, sigma_r);
        pose.tail<4>() =
            quaternionProduct(pose.tail<4>(), quaternionExp(normalVector<3>(rng, sigma_theta)));
    }
    for (WindowLandmark& landmark : window.landmarks)
    {
        if (landmark.kind == LandmarkKind::Point)
            landmark.y *= 1.0 + relative * normalVector<1>(rng, 1.0)[0];
        else
            landmark.y(inverse_depth::kRho) *= std::exp(relative * normalVector<1>(rng, 1.0)[0]);
    }
    return window;
}

TEST(SmoothWindow, RecoversTruthFromExactPixels)
{
    const Camera camera;
    const Window truth = trueWindow(camera, 0.3);
    std::mt19937 rng(2);
    WindowOptions options;
    options.maxIterations = 40;
    for (int run = 0; run < 5; ++run)
    {
        const auto smoothed =
            smoothWindow(camera, perturbed(truth, 0.01, 0.01, 0.15, rng), options);
        EXPECT_TRUE(smoothed.usable);
        EXPECT_LT(smoothed.meanChi2, 1e-6);
        for (std::size_t k = 0; k < truth.poses.size(); ++k)
            EXPECT_LT(poseDifference(truth.poses[k], smoothed.poses[k]).norm(), 1e-5);
        for (std::size_t i = 0; i < truth.landmarks.size(); ++i)
            EXPECT_LT((smoothed.landmarks[i].y - truth.landmarks[i].y).norm(), 1e-4);
        for (const bool inlier : smoothed.inlier) EXPECT_TRUE(inlier);
    }
}

TEST(SmoothWindow, KeepsTheFirstPoseAndTheUnit)
{
    const Camera camera;
    Window window = trueWindow(camera, 0.3);
    std::mt19937 rng(3);
    window.poses.back().head<3>() *= 1.5;  // another unit: all else must follow
    const auto smoothed = smoothWindow(camera, perturbed(window, 0.01, 0.01, 0.1, rng));
    const Window truth = trueWindow(camera, 0.3);
    EXPECT_LT(poseDifference(truth.poses.front(), smoothed.poses.front()).norm(), 1e-6);
    EXPECT_NEAR(smoothed.poses.back().head<3>().norm(), 1.5 * truth.poses.back().head<3>().norm(),
                1e-4);
    EXPECT_LT((smoothed.poses[3].head<3>() - 1.5 * truth.poses[3].head<3>()).norm(), 1e-3);
}

TEST(SmoothWindow, TakesTheScaleFromKnownPoints)
{
    const Camera camera;
    const Window truth = trueWindow(camera, 0.3);
    Window window = truth;
    window.scaleSigma = 0.0;
    window.firstPoseInformation = 1e-9 * Eigen::Matrix<double, 6, 6>::Identity();
    for (int i = 0; i < 4; ++i)
    {
        WindowLandmark& known = window.landmarks[static_cast<std::size_t>(3 * i)];
        known.priorMean = known.y;
        known.priorInformation.setConstant(1.0 / (0.0005 * 0.0005));
    }
    for (Vector7d& pose : window.poses) pose.head<3>() *= 1.1;
    const auto smoothed = smoothWindow(camera, window);
    EXPECT_TRUE(smoothed.usable);
    for (std::size_t k = 0; k < truth.poses.size(); ++k)
        EXPECT_LT(poseDifference(truth.poses[k], smoothed.poses[k]).norm(), 1e-4);
}

TEST(SmoothWindow, MarksWrongPixels)
{
    const Camera camera;
    const Window truth = trueWindow(camera, 0.3);
    std::mt19937 rng(4);
    Window window = perturbed(truth, 0.002, 0.002, 0.05, rng);
    std::vector<bool> wrong(window.observations.size(), false);
    for (std::size_t i = 0; i < wrong.size(); ++i)
    {
        window.observations[i].z += normalVector<2>(rng, 0.3);
        wrong[i] = i % 10 == 3;
        if (wrong[i])
            window.observations[i].z += uniform(rng, 8, 30) * normalVector<2>(rng, 1).normalized();
    }
    const auto smoothed = smoothWindow(camera, window);
    int lost = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i)
    {
        if (wrong[i])
            EXPECT_FALSE(smoothed.inlier[i]) << i;
        else
            lost += smoothed.inlier[i] ? 0 : 1;
    }
    EXPECT_LE(lost, 3);
    EXPECT_NEAR(smoothed.meanChi2, 1.4, 0.4);  // 2 less the share of the estimated numbers
    EXPECT_LT(poseDifference(truth.poses.back(), smoothed.poses.back()).norm(), 0.01);
}

/** Errors of the last two poses and of some landmarks, in the order of P. */
Eigen::VectorXd errors(const Window& truth, const SmoothedWindow& smoothed, int landmarks)
{
    Eigen::VectorXd e(12 + 3 * landmarks);
    const std::size_t last = truth.poses.size() - 1;
    e.head<6>() = poseDifference(truth.poses[last - 1], smoothed.poses[last - 1]);
    e.segment<6>(6) = poseDifference(truth.poses[last], smoothed.poses[last]);
    for (int i = 0; i < landmarks; ++i)
    {
        const auto l = static_cast<std::size_t>(i);
        e.segment<3>(12 + 3 * i) = (smoothed.landmarks[l].y - truth.landmarks[l].y).tail<3>();
    }
    return e;
}

TEST(SmoothWindow, CovarianceIsThatOfItsErrors)
{
    const Camera camera;
    const double sigma_px = 0.3;
    const Window truth = trueWindow(camera, sigma_px);
    std::mt19937 rng(5);
    WindowOptions options;
    options.huber_sigmas = 1e3;  // the covariance is that of least squares
    options.outlierChi2 = 1e3;
    constexpr int kRuns = 150;
    constexpr int kSome = 5;
    double neesPoses = 0.0;
    double neesAll = 0.0;
    for (int run = 0; run < kRuns; ++run)
    {
        Window window = truth;
        window.poses.back().head<3>() *= 1.0 + kScaleSigma * normalVector<1>(rng, 1.0)[0];
        for (WindowObservation& seen : window.observations)
            seen.z += normalVector<2>(rng, sigma_px);
        const auto smoothed = smoothWindow(camera, window, options);
        ASSERT_TRUE(smoothed.usable);
        const Eigen::VectorXd e = errors(truth, smoothed, kSome);
        const Eigen::MatrixXd P =
            smoothed.P.block(6, 6, e.size(), e.size());  // behind the fixed first view
        neesAll += e.dot(P.ldlt().solve(e)) / kRuns;
        const Eigen::VectorXd poses = e.head<12>();
        neesPoses += poses.dot(P.topLeftCorner<12, 12>().ldlt().solve(poses)) / kRuns;
    }
    // 12 and 27 numbers; three standard deviations of the mean of 150 draws.
    EXPECT_NEAR(neesPoses, 12.0, 3.0 * std::sqrt(2.0 * 12.0 / kRuns));
    EXPECT_NEAR(neesAll, 27.0, 3.0 * std::sqrt(2.0 * 27.0 / kRuns));
}

TEST(SmoothWindow, NeedsTwoViews)
{
    const Camera camera;
    Window window = trueWindow(camera, 0.3);
    window.poses.resize(1);
    window.observations.clear();
    EXPECT_THROW((void)smoothWindow(camera, window), std::invalid_argument);
}
}  // namespace
}  // namespace monoslam
