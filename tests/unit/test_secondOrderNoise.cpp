// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "monoslam_filter/editBelief.h"
#include "monoslam_filter/secondOrderNoise.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
Belief oneLandmark(double sigma_r)
{
    Vector13d x_v = Vector13d::Zero();
    x_v[camera_state::kOrientation] = 1.0;
    const Camera camera;
    Belief belief = Belief::ofCamera(x_v, Matrix13d::Zero());
    belief = addUndelayed(belief, camera, 0, {400.0, 300.0}, {1.0, 0.3, 1e-3}).value();
    belief.P.topLeftCorner<3, 3>() = sigma_r * sigma_r * Eigen::Matrix3d::Identity();
    return belief;
}

TEST(SecondOrderNoise, IsTheVarianceThatLinearisationMisses)
{
    const double sigma_r = 0.02;
    const Belief belief = oneLandmark(sigma_r);
    const Camera camera;
    const Prediction prediction = predictMeasurements(belief, camera, {0.0, 1.0});
    ASSERT_EQ(prediction.count(), 1);

    std::mt19937 rng(3);
    const int draws = 200000;
    Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
    for (int i = 0; i < draws; ++i)
    {
        Belief drawn = belief;
        drawn.x.head<3>() += normalVector<3>(rng, sigma_r);
        drawn.x[drawn.size() - 1] += normalVector<1>(rng, 0.3)[0];
        const auto uv = projectPixel(camera, drawn.camera(), LandmarkKind::InverseDepth,
                                     drawn.x.tail(inverse_depth::kSize));
        const Eigen::Vector2d nu = *uv - prediction.rows[0].h;
        S += nu * nu.transpose() / draws;
    }
    const Eigen::Matrix2d linear = prediction.rows[0].S - prediction.rows[0].R;
    const Eigen::Matrix2d both = linear + secondOrderNoise(belief, camera, prediction.rows[0]);
    EXPECT_GT((S - linear).norm(), 0.05 * S.norm());
    EXPECT_LT((S - both).norm(), 0.02 * S.norm());
}

TEST(SecondOrderNoise, VanishesForPointsAndForKnownPositions)
{
    const Camera camera;
    Belief belief = oneLandmark(0.0);
    belief = addPoint(std::move(belief), 1, {0.1, 0.0, 2.0}, 1e-4 * Eigen::Matrix3d::Identity());
    const Prediction prediction = predictMeasurements(belief, camera, {0.0, 1.0});
    ASSERT_EQ(prediction.count(), 2);
    for (const PredictedLandmark& row : prediction.rows)
        EXPECT_LT(secondOrderNoise(belief, camera, row).norm(), 1e-12);
}
}  // namespace
}  // namespace monoslam
