// SPDX-License-Identifier: BSD-3-Clause
#include "ReadoutEstimator.h"

#include <gtest/gtest.h>

#include "monoslam_filter/editBelief.h"
#include "monoslam_models/projectLandmark.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
Camera cameraWith(double readout_s)
{
    CameraParameters p;
    p.readout_s = readout_s;
    return Camera(p);
}

/** A camera that turns and moves before known points, and what its shutter makes of them. */
struct Scene
{
    Belief belief;
    std::vector<Association> seen;
};

Scene sceneBefore(const Camera& camera, std::mt19937& rng)
{
    Vector13d x_v = Vector13d::Zero();
    x_v(camera_state::kOrientation) = 1.0;
    x_v.tail<6>() << normalVector<3>(rng, 0.3), normalVector<3>(rng, 0.5);
    Scene scene{Belief::ofCamera(x_v, 1e-4 * Matrix13d::Identity()), {}};
    for (LandmarkId id = 0; id < 40; ++id)
    {
        const Eigen::Vector3d p_w =
            Eigen::Vector3d(uniform(rng, -0.5, 0.5), uniform(rng, -0.4, 0.4), 1.0) *
            uniform(rng, 1.0, 3.0);
        scene.belief =
            addPoint(std::move(scene.belief), id, p_w, 1e-6 * Eigen::Matrix3d::Identity());
        Association association;
        association.id = id;
        association.fate = Fate::Matched;
        association.z =
            *projectPixel(camera, x_v, LandmarkKind::Point, p_w) + normalVector<2>(rng, 0.2);
        scene.seen.push_back(association);
    }
    return scene;
}

double estimateAfter(int frames, double truth_s, double used_s)
{
    std::mt19937 rng(4);
    const Camera truth = cameraWith(truth_s);
    Camera used = cameraWith(used_s);
    ReadoutEstimator estimator;
    estimator.startAt(used_s);
    for (int frame = 0; frame < frames; ++frame)
    {
        const Scene scene = sceneBefore(truth, rng);
        estimator.observe(scene.belief, used, scene.seen, 0.2);
        used.setReadout(estimator.readout_s());
    }
    return estimator.readout_s();
}

TEST(ReadoutEstimator, FindsARollingShutter)
{
    EXPECT_NEAR(estimateAfter(100, 0.025, 0.0), 0.025, 0.001);
    EXPECT_NEAR(estimateAfter(100, 0.012, 0.03), 0.012, 0.001);
}

TEST(ReadoutEstimator, TakesAGlobalShutterForOne)
{
    for (const int frames : {1, 10, 50, 100, 200}) EXPECT_EQ(estimateAfter(frames, 0.0, 0.0), 0.0);
}

TEST(ReadoutEstimator, ForgetsAWrongGuessOfAGlobalShutter)
{
    EXPECT_EQ(estimateAfter(200, 0.0, 0.02), 0.0);
}

TEST(ReadoutEstimator, LearnsNothingFromAFewPairs)
{
    std::mt19937 rng(5);
    const Camera truth = cameraWith(0.03);
    Scene scene = sceneBefore(truth, rng);
    scene.seen.resize(11);
    ReadoutEstimator estimator;
    for (int i = 0; i < 100; ++i) estimator.observe(scene.belief, cameraWith(0.0), scene.seen, 0.2);
    EXPECT_EQ(estimator.readout_s(), 0.0);
}
}  // namespace
}  // namespace monoslam
