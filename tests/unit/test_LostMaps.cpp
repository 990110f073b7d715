// SPDX-License-Identifier: BSD-3-Clause
#include "LostMaps.h"

#include <gtest/gtest.h>

#include "monoslam_filter/editBelief.h"
#include "poseError.h"
#include "wavyPlane.h"

namespace monoslam
{
namespace
{
constexpr double kSigma_m = 0.001;

Vector7d firstPose()
{
    return lookAt({0.01, -0.05, 0.5}, {0.0, 0.0, 0.0}, 0.0);
}

Vector7d laterPose()
{
    return lookAt({0.1, -0.1, 0.44}, {0.02, 0.0, 0.0}, 0.5);
}

/** A map of what the first view sees. */
LostMap mapOf(unsigned seed, std::size_t most = 1000)
{
    LostMap map;
    Vector13d x_v = Vector13d::Zero();
    x_v.head<7>() = firstPose();
    map.belief = Belief::ofCamera(x_v, 1e-4 * Matrix13d::Identity());
    map.rho0 = 2.0;
    const auto image = wavyView(firstPose(), seed);
    const auto pixels = cornersOf(*image);
    const auto corners = pointsOfPlane(smallCamera(), firstPose(), pixels);
    for (std::size_t i = 0; i < std::min(most, corners.size()); ++i)
    {
        const auto id = static_cast<LandmarkId>(100 + i);
        map.belief = addPoint(std::move(map.belief), id, corners[i],
                              kSigma_m * kSigma_m * Eigen::Matrix3d::Identity());
        map.records[id].born = {image, pixels[i], firstPose(), {}};
    }
    return map;
}

Belief resting()
{
    Vector13d x_v = Vector13d::Zero();
    x_v(camera_state::kOrientation) = 1.0;
    return Belief::ofCamera(x_v, 0.25 * Matrix13d::Identity());
}

/** Of exact pixels of the map's landmarks, seen from a pose. */
MapSighting sightingFrom(const LostMap& map, const Vector7d& pose)
{
    MapSighting sighting;
    sighting.pose = {rotationMatrix(pose.tail<4>()), pose.head<3>()};
    for (const LandmarkSlot& slot : map.belief.landmarks)
    {
        const Eigen::Vector3d p_w = map.belief.x.segment<3>(slot.offset);
        const auto uv_px =
            smallCamera().project(rotateInverse(pose.tail<4>(), p_w - pose.head<3>()));
        if (!uv_px || !smallCamera().contains(*uv_px)) continue;
        sighting.ids.push_back(slot.id);
        sighting.uv_px.push_back(*uv_px);
    }
    return sighting;
}
}  // namespace

TEST(LostMaps, AreFoundByWhatTheirLandmarksLookLike)
{
    LostMaps lost;
    lost.keep(mapOf(1), {});
    ASSERT_FALSE(lost.empty());
    const auto found = lost.find(*wavyView(laterPose(), 1), smallCamera(), false);
    ASSERT_EQ(found.size(), 1U);
    const Eigen::Matrix3d R_true = rotationMatrix(laterPose().tail<4>());
    EXPECT_LT((found[0].pose.r_wc - laterPose().head<3>()).norm(), 0.02);
    EXPECT_LT((found[0].pose.R_wc - R_true).norm(), 0.06);
    EXPECT_GE(found[0].ids.size(), 6U);
    EXPECT_EQ(found[0].ids.size(), found[0].uv_px.size());
    EXPECT_TRUE(lost.find(*wavyView(laterPose(), 2), smallCamera(), false).empty());
}

TEST(LostMaps, AreFoundByTheLastViewWhereTheFirstWasAnother)
{
    LostMap map = mapOf(1);
    const auto elsewhere = wavyView(firstPose(), 3);
    for (auto& [id, record] : map.records) record.born.image = elsewhere;
    LastView last{wavyView(firstPose(), 1), {}};
    for (const auto& [id, record] : map.records) last.pixels.emplace_back(id, record.born.uv_px);
    LostMaps without, with;
    without.keep(map, {});
    with.keep(std::move(map), last);
    EXPECT_TRUE(without.find(*wavyView(laterPose(), 1), smallCamera(), false).empty());
    EXPECT_EQ(with.find(*wavyView(laterPose(), 1), smallCamera(), false).size(), 1U);
}

TEST(LostMaps, KeepOnlyWhatOneCanComeBackTo)
{
    LostMaps lost;
    lost.keep(mapOf(1, 11), {});
    EXPECT_TRUE(lost.empty());
    LostMap vague = mapOf(1);
    for (LandmarkSlot& slot : vague.belief.landmarks) slot.id += 1000;  // looks of no landmark
    lost.keep(std::move(vague), {});
    EXPECT_TRUE(lost.empty());

    for (int k = 0; k < 5; ++k)
    {
        LostMap map = mapOf(1);
        map.guessed = k > 0;
        map.rho0 = k;
        lost.keep(std::move(map), {});
    }
    EXPECT_EQ(lost.at(0).rho0, 0.0);  // the first, and the latest
    EXPECT_EQ(lost.at(1).rho0, 3.0);
    EXPECT_EQ(lost.at(2).rho0, 4.0);
    EXPECT_THROW(static_cast<void>(lost.at(3)), std::out_of_range);
    const auto image = wavyView(laterPose(), 1);
    EXPECT_EQ(lost.find(*image, smallCamera(), false).size(), 1U);
    EXPECT_EQ(lost.find(*image, smallCamera(), true).size(), 3U);
    EXPECT_EQ(lost.takeOut(1).rho0, 3.0);
    EXPECT_EQ(lost.at(1).rho0, 4.0);
    EXPECT_EQ(lost.takeOut(0).rho0, 0.0);  // all that were begun after it tell less
    EXPECT_TRUE(lost.empty());
}

/** Of a map without error the pose is known as well as the pixels say; the pose of one with a common error
 *  has that error, too, and the map learns nothing of it. */
TEST(LostMaps, ThePlacedCameraIsAsUncertainAsPixelsAndMap)
{
    LostMap map = mapOf(1);
    const Eigen::Index n = map.belief.size() - 13;
    map.belief.P.bottomRightCorner(n, n) *= 1e-6;
    const MapSighting sighting = sightingFrom(map, laterPose());
    ASSERT_GT(sighting.ids.size(), 15U);
    Belief exact = placeInMap(map, sighting, smallCamera(), resting(), FilterEngine());
    exact.checkInvariant();
    EXPECT_LT(poseDifference(laterPose(), exact.pose()).norm(), 1e-9);
    SeenPoints seen;
    for (std::size_t i = 0; i < sighting.ids.size(); ++i)
    {
        const auto& slot =
            map.belief.landmarks[static_cast<std::size_t>(map.belief.find(sighting.ids[i]))];
        seen.points_m.emplace_back(map.belief.x.segment<3>(slot.offset));
        seen.pixels_px.push_back(sighting.uv_px[i]);
        seen.sigmas_px.push_back(2.0);
    }
    const Matrix6d byPixels =
        informationOf(*pointTerms(seen, smallCamera(), sighting.pose)).inverse();
    const Matrix6d P = covariance6(exact.pose(), exact.P.topLeftCorner<7, 7>());
    EXPECT_LT((P - byPixels).norm(), 0.02 * byPixels.norm());
    EXPECT_EQ(exact.camera().tail<6>(), resting().camera().tail<6>());
    EXPECT_TRUE((exact.P.block<6, 6>(7, 7)).isApprox(0.25 * Matrix6d::Identity()));

    constexpr double kCommon_m = 0.05;
    for (Eigen::Index a = 0; a < n; ++a)
        for (Eigen::Index b = a % 3; b < n; b += 3)
            map.belief.P(13 + a, 13 + b) += kCommon_m * kCommon_m;
    const Belief common = placeInMap(map, sighting, smallCamera(), resting(), FilterEngine());
    common.checkInvariant();
    const Matrix6d more = covariance6(common.pose(), common.P.topLeftCorner<7, 7>()) - P;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::sqrt(more(k, k)), kCommon_m, 0.03 * kCommon_m);
    EXPECT_NEAR(std::sqrt(common.P(13, 13)), kCommon_m, 0.03 * kCommon_m);
}
}  // namespace monoslam
