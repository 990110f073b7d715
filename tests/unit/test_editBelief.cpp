// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/editBelief.h"

#include <gtest/gtest.h>

#include "jacobianMatches.h"
#include "monoslam_models/quaternion.h"
#include "randomBelief.h"

namespace monoslam
{
namespace
{
constexpr double kTolerance = 1e-7;
const RandomBeliefOptions kMixed{6, 2, true};

/** P of (x, new) by dense propagation of diag(P, R) through f(x, noise) = new. */
template <typename Function>
Eigen::MatrixXd densePropagation(const Belief& belief, const Function& f,
                                 const Eigen::VectorXd& inputs, const Eigen::VectorXd& variances)
{
    const Eigen::Index n = belief.size();
    Eigen::VectorXd all(n + inputs.size());
    all << belief.x, inputs;
    const Eigen::MatrixXd J_new = numericalJacobian(f, all, 1e-4);
    Eigen::MatrixXd P = Eigen::MatrixXd::Zero(all.size(), all.size());
    P.topLeftCorner(n, n) = belief.P;
    P.diagonal().tail(inputs.size()) = variances;
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n + J_new.rows(), all.size());
    J.topLeftCorner(n, n).setIdentity();
    J.bottomRows(J_new.rows()) = J_new;
    return J * P * J.transpose();
}

TEST(EditBelief, UndelayedLandmarkHasTheDenselyPropagatedCovariance)
{
    std::mt19937 rng(1);
    const Camera camera;
    const UndelayedPrior prior{0.7, 0.2, 0.5};
    for (int trial = 0; trial < 20; ++trial)
    {
        const Belief before = randomBelief(rng, camera, kMixed);
        const Eigen::Vector2d uv(uniform(rng, 50, 590), uniform(rng, 50, 430));
        const Belief after = addUndelayed(before, camera, 99, uv, prior).value();
        const auto f = [&](const Eigen::VectorXd& all)
        {
            return Eigen::VectorXd(initializeUndelayed(camera, all.head<7>(),
                                                       all.tail<3>().head<2>(), all[all.size() - 1])
                                       ->y);
        };
        const Eigen::MatrixXd P = densePropagation(before, f, Eigen::Vector3d(uv[0], uv[1], 0.7),
                                                   Eigen::Vector3d(0.25, 0.25, 0.04));
        EXPECT_LT(largestDifference(after.P, P), kTolerance);
        EXPECT_NO_THROW(after.checkInvariant());
    }
}

TEST(EditBelief, SeveralUndelayedLandmarksAreTheSameAsOneAfterTheOther)
{
    std::mt19937 rng(6);
    CameraParameters rolling;
    rolling.readout_s = 0.03;
    for (const Camera& camera : {Camera(), Camera(rolling)})
    {
        const UndelayedPrior prior{0.7, 0.2, 0.5};
        const Belief before = randomBelief(rng, camera, kMixed);
        std::vector<NewLandmark> corners;
        Belief oneByOne = before;
        for (LandmarkId id = 90; id < 98; ++id)
        {
            corners.push_back({id, {uniform(rng, 50, 590), uniform(rng, 50, 430)}});
            oneByOne = addUndelayed(oneByOne, camera, id, corners.back().uv_px, prior).value();
        }
        const Belief atOnce = addUndelayed(before, camera, corners, prior);
        EXPECT_LT((atOnce.x - oneByOne.x).norm(), kTolerance);
        EXPECT_LT(largestDifference(atOnce.P, oneByOne.P), kTolerance);
        EXPECT_NO_THROW(atOnce.checkInvariant());
        for (const NewLandmark& corner : corners)
            EXPECT_EQ(atOnce.find(corner.id), oneByOne.find(corner.id));
    }
}

struct TwoViews
{
    Camera camera;
    Belief belief;
    View first, current;
};

/** A clone, then a step of 0.4 m to the side; both see a point three metres ahead. */
TwoViews makeTwoViews(std::mt19937& rng)
{
    TwoViews views;
    views.belief = randomBelief(rng, views.camera, {3, 0, true});
    const CloneSlot clone = views.belief.clones[0];
    const Vector7d pose0 = views.belief.clonePose(clone);
    const Eigen::Vector3d side = monoslam::rotate(pose0.tail<4>(), {0.4, 0.1, 0.05});
    views.belief.x.head<3>() = pose0.head<3>() + side;
    const Eigen::Vector3d p_w =
        pose0.head<3>() +
        rotate(pose0.tail<4>(), {uniform(rng, -1, 1), uniform(rng, -0.8, 0.8), 3});
    Vector13d x_v = views.belief.camera();
    views.current = {views.belief.pose(),
                     *projectPixel(views.camera, x_v, LandmarkKind::Point, p_w)};
    x_v.head<7>() = pose0;
    views.first = {pose0, *projectPixel(views.camera, x_v, LandmarkKind::Point, p_w)};
    return views;
}

TEST(EditBelief, CloneModeHasTheDenselyPropagatedCovariance)
{
    std::mt19937 rng(2);
    for (int trial = 0; trial < 20; ++trial)
    {
        const auto [camera, before, first, current] = makeTwoViews(rng);
        const Eigen::Index clone = before.clones[0].offset;
        const auto t = triangulate(camera, first, current);
        ASSERT_TRUE(t);
        const Belief after =
            addTriangulated(before, 99, *t, {before.clones[0].id, {}, {}, first.uv_px}, 0.5, 0.0);
        const auto f = [&camera = camera, clone](const Eigen::VectorXd& all)
        {
            return Eigen::VectorXd(triangulate(camera, {all.segment<7>(clone), all.tail<2>()},
                                               {all.head<7>(), all.tail<4>().head<2>()})
                                       ->y);
        };
        Eigen::Vector4d uv;
        uv << current.uv_px, first.uv_px;
        const Eigen::MatrixXd P = densePropagation(before, f, uv, Eigen::Vector4d::Constant(0.25));
        EXPECT_LT(largestDifference(after.P, P), 1e-6);
    }
}

TEST(EditBelief, PaperModeTakesTheFirstPoseAsIndependent)
{
    std::mt19937 rng(3);
    const auto [camera, before, first, current] = makeTwoViews(rng);
    const auto t = triangulate(camera, first, current);
    const Vector7d variance = before.P.diagonal().segment<7>(before.clones[0].offset);
    const Belief after =
        addTriangulated(before, 99, *t, {-1, first.pose, variance, first.uv_px}, 0.5, 0.0);
    const Eigen::MatrixXd J = t->J_current.leftCols<7>();
    const Eigen::MatrixXd P_yx = J * before.P.topRows<7>();
    EXPECT_LT(largestDifference(after.P.bottomLeftCorner(6, before.size()), P_yx), 1e-12);
    EXPECT_THROW((void)addTriangulated(before, 9, *t, {55, {}, {}, first.uv_px}, 0.5, 0.0),
                 std::invalid_argument);
}

TEST(EditBelief, FloorRaisesOnlyTheVarianceOfRho)
{
    std::mt19937 rng(4);
    const auto [camera, before, first, current] = makeTwoViews(rng);
    const auto t = triangulate(camera, first, current);
    const FirstView view{before.clones[0].id, {}, {}, first.uv_px};
    const Belief free = addTriangulated(before, 99, *t, view, 1e-3, 0.0);
    const Belief floored = addTriangulated(before, 99, *t, view, 1e-3, 10.0);
    Eigen::MatrixXd difference = floored.P - free.P;
    EXPECT_NEAR(floored.P(free.size() - 1, free.size() - 1), std::pow(10.0 * t->y[5], 2), 1e-9);
    difference(free.size() - 1, free.size() - 1) = 0.0;
    EXPECT_EQ(difference.norm(), 0.0);
}

TEST(EditBelief, RemovingMarginalises)
{
    std::mt19937 rng(5);
    const Belief before = randomBelief(rng, Camera(), kMixed);
    const Belief after = removeClones(removeLandmarks(before, {1, 4, 1234}), {7});
    EXPECT_NO_THROW(after.checkInvariant());
    EXPECT_EQ(after.landmarks.size(), before.landmarks.size() - 2);
    EXPECT_TRUE(after.clones.empty());
    for (const LandmarkSlot& a : after.landmarks)
        for (const LandmarkSlot& b : after.landmarks)
        {
            const auto& a0 = before.landmarks[static_cast<std::size_t>(before.find(a.id))];
            const auto& b0 = before.landmarks[static_cast<std::size_t>(before.find(b.id))];
            EXPECT_EQ(after.P.block(a.offset, b.offset, a.size(), b.size()),
                      before.P.block(a0.offset, b0.offset, a.size(), b.size()));
            EXPECT_EQ(after.x.segment(a.offset, a.size()), before.x.segment(a0.offset, a.size()));
        }
}

TEST(EditBelief, ConversionToPointsMovesNoPixelAndNoPredictedCovariance)
{
    std::mt19937 rng(6);
    const Camera camera;
    const Belief before = randomBelief(rng, camera, {6, 0, true});
    const Belief after = convertToPoints(before, {0, 2, 5});
    EXPECT_EQ(after.size(), before.size() - 9);
    EXPECT_NO_THROW(after.checkInvariant());
    const Prediction a = predictMeasurements(before, camera, {});
    const Prediction b = predictMeasurements(after, camera, {});
    ASSERT_EQ(a.count(), b.count());
    for (std::size_t i = 0; i < a.rows.size(); ++i)
        EXPECT_LT((a.rows[i].h - b.rows[i].h).norm(), 1e-8);
    EXPECT_LT(largestDifference(a.HPHt, b.HPHt), 1e-6);
}

TEST(EditBelief, RescalingMovesNoPixelAndNoPredictedCovariance)
{
    std::mt19937 rng(7);
    const Camera camera;
    const Belief before = randomBelief(rng, camera, kMixed);
    const Belief after = rescale(before, 2.5);
    const Prediction a = predictMeasurements(before, camera, {});
    const Prediction b = predictMeasurements(after, camera, {});
    ASSERT_EQ(a.count(), b.count());
    for (std::size_t i = 0; i < a.rows.size(); ++i)
        EXPECT_LT((a.rows[i].h - b.rows[i].h).norm(), 1e-8);
    EXPECT_LT(largestDifference(a.HPHt, b.HPHt), 1e-6);
    EXPECT_LT(largestDifference(rescale(after, 0.4).P, before.P), 1e-9);
}
}  // namespace
}  // namespace monoslam
