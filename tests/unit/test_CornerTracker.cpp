// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/CornerTracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cornerScene.h"

namespace monoslam
{
TEST(CornerTracker, FollowsEveryCornerToItsTruePixelAndDepth)
{
    constexpr int kFrames = 8;
    const auto first = frameOf(0);
    const auto points = mosaicCorners(kSide_m, smallCamera(), poseOf(0), 30.0);
    ASSERT_GT(points.size(), 10U);
    std::vector<TrackedCorner> corners;
    double sum_px2 = 0.0;
    for (const auto& p_w : points) corners.push_back(newborn(p_w, first));
    for (int k = 1; k < kFrames; ++k)
    {
        const auto image = frameOf(k);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            auto followed = track(corners[i], beliefAt(poseOf(k)), *image, k);
            ASSERT_TRUE(followed) << points[i].transpose() << " in frame " << k;
            corners[i] = *followed;
            EXPECT_EQ(corners[i].seen, k + 1);
            const double error_px = (corners[i].uv_px - pixelOf(points[i], poseOf(k))).norm();
            EXPECT_LT(error_px, 0.3);
            sum_px2 += error_px * error_px;
        }
    }
    const auto count = static_cast<double>(points.size() * (kFrames - 1));
    EXPECT_LT(std::sqrt(sum_px2 / count), 0.12);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double rho = 1.0 / (points[i] - poseOf(0).head<3>()).norm();
        EXPECT_LT(std::abs(corners[i].rho - rho), corners[i].sigma_rho);
        EXPECT_LT(corners[i].sigma_rho, 0.2 * rho);
        ASSERT_TRUE(corners[i].triangulation);
        EXPECT_LT((toPoint(corners[i].triangulation->y) - points[i]).norm(), 0.02 / rho);
    }
}

TEST(CornerTracker, LooksAlongTheRayOnlyAsFarAsTheDepthMayBe)
{
    const auto first = frameOf(0);
    const auto image = frameOf(7);
    const Eigen::Vector3d p_w(0.0, 0.0, 0.0);
    TrackedCorner corner = newborn(p_w, first, 1.8);  // 15 px from where it would be
    corner.sigma_rho = 0.3 * corner.rho;
    const Vector7d pose = poseOf(7);
    const auto found = track(corner, beliefAt(pose), *image);
    ASSERT_TRUE(found);
    EXPECT_LT((found->uv_px - pixelOf(p_w, pose)).norm(), 0.2);
    corner.sigma_rho = 0.05 * corner.rho;
    const auto missed = track(corner, beliefAt(pose), *image);
    ASSERT_TRUE(missed);
    EXPECT_EQ(missed->missed, 1);
    EXPECT_FALSE(missed->triangulation);
}

TEST(CornerTracker, DoesNotLookBesideTheRay)
{
    const auto first = frameOf(0);
    const auto image = frameOf(7);
    const Vector7d pose = poseOf(7);
    const TrackedCorner corner = newborn({0.0, 0.0, 0.0}, first);
    for (const double off_px : {-8.0, 8.0})  // the ray runs along the rows here
    {
        Vector7d wrong = pose;
        const Eigen::Vector3d nod(off_px / smallCamera().parameters().fx_px, 0.0, 0.0);
        wrong.tail<4>() = quaternionProduct(pose.tail<4>(), quaternionExp(nod));
        const auto missed = track(corner, beliefAt(wrong), *image);
        ASSERT_TRUE(missed);
        EXPECT_EQ(missed->missed, 1) << off_px;
        EXPECT_EQ(missed->uv_px, corner.uv_px);
    }
}

/** Columns of the same two squares again and again: nothing tells one corner from the next. */
TEST(CornerTracker, OfTwoPlacesThatLookAlikeItTakesNone)
{
    PaintedPlane plane = mosaic(0.02);
    plane.light = [light = plane.light](double x_m, double y_m)
    { return light(x_m - 0.04 * std::floor(x_m / 0.04), y_m); };
    const auto first = imageOf(plane, poseOf(0), 1);
    const auto image = imageOf(plane, poseOf(7), 2);
    const TrackedCorner corner = newborn({0.0, 0.0, 0.0}, first);
    CornerTrackerOptions options;
    const auto missed = track(corner, beliefAt(poseOf(7)), *image, 1, options);
    ASSERT_TRUE(missed);
    EXPECT_EQ(missed->missed, 1);
    options.uniqueness = 0.0;
    const auto taken = track(corner, beliefAt(poseOf(7)), *image, 1, options);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->seen, 2);
}

TEST(CornerTracker, GivesUpAfterTooManyMissesInARow)
{
    const CornerTrackerOptions options;
    const auto nothing = blank();
    std::optional<TrackedCorner> corner = newborn({0.0, 0.0, 0.0}, frameOf(0));
    corner->seen = 100;
    for (int miss = 1; miss <= options.maxMissedInRow; ++miss)
    {
        corner = track(*corner, beliefAt(poseOf(1)), *nothing, miss, options);
        ASSERT_TRUE(corner) << miss;
        EXPECT_EQ(corner->missedInRow, miss);
        EXPECT_EQ(corner->seen, 100);
    }
    EXPECT_FALSE(track(*corner, beliefAt(poseOf(1)), *nothing));
    const auto again = track(*corner, beliefAt(poseOf(1)), *frameOf(1));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->missedInRow, 0);
    EXPECT_EQ(again->missed, options.maxMissedInRow);
}

TEST(CornerTracker, GivesUpWhatItMissesMoreOftenThanSees)
{
    const auto nothing = blank();
    TrackedCorner corner = newborn({0.0, 0.0, 0.0}, frameOf(0));
    corner.seen = 4;
    corner.missed = 3;
    EXPECT_TRUE(track(corner, beliefAt(poseOf(1)), *nothing));
    corner.missed = 4;
    EXPECT_FALSE(track(corner, beliefAt(poseOf(1)), *nothing));
}

TEST(CornerTracker, GivesUpWhatIsTooOldOrHasLeftTheImage)
{
    const auto image = frameOf(1);
    TrackedCorner corner = newborn({0.0, 0.0, 0.0}, frameOf(0));
    corner.bornFrame = 10;
    const CornerTrackerOptions options;
    EXPECT_TRUE(track(corner, beliefAt(poseOf(1)), *image, 10 + options.maxAge_frames));
    EXPECT_FALSE(track(corner, beliefAt(poseOf(1)), *image, 11 + options.maxAge_frames));
    const Vector7d elsewhere = lookAt({0.0, -0.02, 0.5}, {0.6, 0.0, 0.0});
    EXPECT_FALSE(track(corner, beliefAt(elsewhere), *image, 11));
    const Vector7d away = lookAt({0.0, -0.02, 0.5}, {0.0, -0.1, 1.0});
    EXPECT_FALSE(track(corner, beliefAt(away), *image, 11));
}

TEST(CornerTracker, ThePatchMustFitIntoTheImageWithTwoPixelsAroundIt)
{
    const auto image = frameOf(1);
    const CornerTrackerOptions options;
    const TrackedCorner corner = newborn({0.0, 0.0, 0.0}, frameOf(0), 1.0);
    const CameraParameters p = smallCamera().parameters();
    const auto angle = [&p](double u_px) { return std::atan((u_px - p.cx_px) / p.fx_px); };
    for (const double beyond_px : {-1.5, 1.5})
    {
        Vector7d pose = poseOf(0);
        const double turn = angle(corner.uv_px.x()) - angle(options.half_px + 2.0 + beyond_px);
        pose.tail<4>() = quaternionProduct(pose.tail<4>(), quaternionExp({0.0, turn, 0.0}));
        EXPECT_EQ(track(corner, beliefAt(pose), *image).has_value(), beyond_px > 0.0);
    }
}

TEST(CornerTracker, TheFirstPoseIsThatOfTheCloneAsLongAsThereIsOne)
{
    const auto image = frameOf(7);
    const Eigen::Vector3d p_w(0.0, 0.0, 0.0);
    TrackedCorner corner = newborn(p_w, frameOf(0));
    corner.first.pose.head<3>() += Eigen::Vector3d(0.1, 0.1, -0.1);  // what was believed at birth
    corner.first.clone = 5;
    Belief belief = addClone(beliefAt(poseOf(0)), 5);
    belief.x.head<7>() = poseOf(7);
    const auto found = track(corner, belief, *image);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->first.pose, poseOf(0));
    ASSERT_TRUE(found->triangulation);
    EXPECT_LT((toPoint(found->triangulation->y) - p_w).norm(), 0.01);
    EXPECT_FALSE(track(corner, removeClones(belief, {5}), *image));
}
}  // namespace monoslam
