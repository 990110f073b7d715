// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MetricStart.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "monoslam_support/ConfigSection.h"
#include "poseError.h"
#include "randomValues.h"
#include "renderPlane.h"

namespace monoslam
{
namespace
{
std::vector<Eigen::Vector3d> rectangle(double x_m, double y_m)
{
    return {{-x_m / 2, -y_m / 2, 0},
            {x_m / 2, -y_m / 2, 0},
            {x_m / 2, y_m / 2, 0},
            {-x_m / 2, y_m / 2, 0}};
}

MetricStartOptions optionsFor(MetricStartMethod method)
{
    MetricStartOptions o;
    o.method = method;
    return o;
}

struct Spread
{
    Matrix6d sum = Matrix6d::Zero();
    double mahalanobis = 0.0;
    Eigen::Matrix<double, 3, 12> withPoints = Eigen::Matrix<double, 3, 12>::Zero();
    int n = 0;
};

Spread monteCarlo(const Camera& camera, const Vector7d& truth, MetricStartOptions o, int draws)
{
    std::mt19937 rng(5);
    const auto points = o.target_points_m;
    const auto exact = seenBy(camera, truth, points);
    Spread spread;
    for (int draw = 0; draw < draws; ++draw)
    {
        auto pixels = exact;
        Eigen::Matrix<double, 12, 1> e;
        for (int i = 0; i < 4; ++i)
        {
            e.segment<3>(3 * i) = normalVector<3>(rng, o.point_sigma_m);
            o.target_points_m[i] = points[i] + e.segment<3>(3 * i);
            pixels[i] += normalVector<2>(rng, o.corner_sigma_px);
        }
        const auto result = metricPoseFrom(pixels, camera, o);
        if (!result.found) continue;
        const Vector6d d = poseDifference(truth, result.found->pose);
        spread.sum += d * d.transpose();
        spread.mahalanobis += mahalanobis2(truth, result.found->pose, result.found->P);
        spread.withPoints += d.head<3>() * e.transpose();
        ++spread.n;
    }
    return spread;
}
}  // namespace

TEST(MetricStart, HasTheSpreadItsCovarianceClaims)
{
    const Camera camera = wideCamera();
    MetricStartOptions o = optionsFor(MetricStartMethod::TargetPoints);
    o.target_points_m = rectangle(0.21, 0.1485);
    for (const double sigma_m : {0.0, 0.0005})
        for (const Eigen::Vector3d& from : {Eigen::Vector3d(0.1, -0.3, 0.35), {-0.3, -0.1, 0.3}})
        {
            o.point_sigma_m = sigma_m;
            const Vector7d truth = lookAt(from, {0.02, 0.01, 0}, 0.3);
            const auto pixels = seenBy(camera, truth, o.target_points_m);
            const auto exact = metricPoseFrom(pixels, camera, o);
            ASSERT_TRUE(exact.found) << exact.reason;
            const Matrix6d C = covariance6(exact.found->pose, exact.found->P);
            const Spread spread = monteCarlo(camera, truth, o, 1200);
            EXPECT_GT(spread.n, 1190);
            for (int i = 0; i < 6; ++i)
                EXPECT_NEAR(std::sqrt(C(i, i) * spread.n / spread.sum(i, i)), 1.0, 0.1) << i;
            EXPECT_NEAR(spread.mahalanobis / spread.n, 6.0, 0.4);
            if (sigma_m == 0.0) continue;
            const Eigen::Matrix<double, 3, 12> cross = exact.found->P_pose_points.topRows<3>();
            EXPECT_LT((spread.withPoints / spread.n - cross).norm(), 0.2 * cross.norm());
        }
}

TEST(MetricStart, FindsTheExactPoseOnAnyPlaneInAnyOrder)
{
    const Camera camera = wideCamera();
    std::mt19937 rng(3);
    MetricStartOptions o = optionsFor(MetricStartMethod::TargetPoints);
    const auto flat = rectangle(0.3, 0.25);
    for (int trial = 0; trial < 200; ++trial)
    {
        const Eigen::Vector4d q_wp = randomQuaternion(rng);
        const Eigen::Vector3d r_wp = uniformVector<3>(rng, 5.0);
        Eigen::Vector3d from(uniform(rng, 0.2, 0.4), uniform(rng, -0.3, 0.3), 0.45);
        if (trial % 2 == 1) from = -from;  // both tilts, both faces of the plane
        const Vector7d local = lookAt(from, uniformVector<3>(rng, 0.05), uniform(rng, -3, 3));
        Vector7d truth;
        truth << rotate(q_wp, local.head<3>()) + r_wp, quaternionProduct(q_wp, local.tail<4>());
        o.target_points_m.clear();
        for (const auto& p : flat) o.target_points_m.emplace_back(rotate(q_wp, p) + r_wp);
        std::shuffle(o.target_points_m.begin(), o.target_points_m.end(), rng);
        const auto pixels = seenBy(camera, truth, o.target_points_m);
        const auto result = metricPoseFrom(pixels, camera, o);
        ASSERT_TRUE(result.found) << trial << ": " << result.reason;
        EXPECT_LT(poseDifference(truth, result.found->pose).norm(), 1e-6) << trial;
        EXPECT_LT((result.found->P - result.found->P.transpose()).norm(), 1e-15);
    }
}

TEST(MetricStart, RefusesATargetWhoseTiltHasTwoReadings)
{
    const Camera camera = wideCamera();
    MetricStartOptions o = optionsFor(MetricStartMethod::TargetPoints);
    o.target_points_m = rectangle(0.1, 0.07);
    for (const double y : {-1.5, 1.5})
    {
        const auto far = seenBy(camera, lookAt({0.1, y, 2.5}, {0, 0, 0}), o.target_points_m);
        const auto result = metricPoseFrom(far, camera, o);
        EXPECT_FALSE(result.found);
        EXPECT_NE(result.reason.find("two tilts"), std::string::npos) << result.reason;
    }
}

TEST(MetricStart, RefusesCornersThatDoNotFit)
{
    const Camera camera = wideCamera();
    MetricStartOptions o = optionsFor(MetricStartMethod::TargetPoints);
    o.target_points_m = rectangle(0.21, 0.1485);
    auto pixels = seenBy(camera, lookAt({0.1, -0.3, 0.35}, {0, 0, 0}), o.target_points_m);
    pixels[2].x() += 8.0;
    const auto result = metricPoseFrom(pixels, camera, o);
    EXPECT_FALSE(result.found);
    EXPECT_NE(result.reason.find("do not fit"), std::string::npos) << result.reason;
}

TEST(MetricStart, SaysWhichKeyOfTheIniIsWrong)
{
    const auto why = [](const std::string& keys)
    {
        try
        {
            const mrpt::config::CConfigFileMemory file("[metric_start]\n" + keys);
            (void)MetricStartOptions::from(ConfigSection(file, "metric_start", "a.ini"));
        }
        catch (const std::invalid_argument& e)
        {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    const std::string px = "target_points_px = 10 10 90 10 90 60 10 60\nmethod = target_points\n";
    EXPECT_EQ(why(px + "target_points_m = 0 0 1  1 0 1  1 1 1  0 1 1\n"), "accepted");
    EXPECT_EQ(why("method = rectangle\nrectangle_size_m = 0.3 0.2\n"), "accepted");
    const std::vector<std::pair<std::string, std::string>> wrong{
        {px + "target_points_m = 0 0 1  1 0 1  1 1 1\n", "target_points_m"},
        {px + "target_points_m = 0 0 0  1 0 0  2 0 0  0 1 0\n", "one line"},
        {px + "target_points_m = 0 0 0  1 0 0  1 1 0  0 1 0.3\n", "one plane"},
        {px, "target_points_m"},
        {"method = rectangle\nrectangle_size_m = 0.3 -0.2\n", "rectangle_size_m"},
        {"method = chessboard\nchessboard_inner_corners = 9 6.5\n", "chessboard_inner_corners"},
        {"method = chessboard\nchessboard_square_m = 0\n", "chessboard_square_m"},
        {"method = sphere\n", "method"},
        {"methd = rectangle\n", "methd"}};
    for (const auto& [keys, named] : wrong)
        EXPECT_NE(why(keys).find(named), std::string::npos) << keys << why(keys);
}
}  // namespace monoslam
