// SPDX-License-Identifier: BSD-3-Clause
#include "iteratedUpdate.h"

#include <gtest/gtest.h>

#include "monoslam_filter/editBelief.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"
#include "relinearize.h"

namespace monoslam
{
namespace
{
constexpr int kKnown = 4;
constexpr int kLandmarks = 34;
constexpr double kSigma_px = 0.1;
constexpr std::ptrdiff_t kFirst = 12;
constexpr int kUnlimited = 20;

/** The second frame of a run: known points and landmarks of unknown depth, seen from a camera that has
 *  moved a little and turned a little. */
class SecondFrame
{
   public:
    SecondFrame(double sigma_rho, unsigned seed) : rng_(seed)
    {
        Matrix13d P_v = Matrix13d::Zero();
        P_v.diagonal().head<3>().setConstant(0.02 * 0.02);
        P_v.diagonal().segment<4>(3).setConstant(0.01 * 0.01);
        P_v(3, 3) = 0.0;
        Vector13d x_v = Vector13d::Zero();
        x_v[3] = 1.0;
        belief_ = Belief::ofCamera(x_v, Matrix13d::Zero());
        truth_ << 0.01, -0.004, 0.002, quaternionExp({0.004, -0.006, 0.003});
        for (LandmarkId id = 0; id < kLandmarks; ++id) add(id, sigma_rho);
        belief_.P.topLeftCorner<13, 13>() = P_v;
        prediction_ = view_.predict(belief_);
        for (std::size_t row = 0; row < prediction_.rows.size(); ++row)
            pixels_.push_back({static_cast<Eigen::Index>(row), see(prediction_.rows[row].id),
                               kSigma_px * kSigma_px * Eigen::Matrix2d::Identity()});
        linearizeByFirst(kFirst);
    }

    Belief update(int maxIterations)
    {
        int faults = 0;
        Belief prior = belief_;
        Belief posterior =
            iteratedUpdate({prior, prediction_, at_}, pixels_, view_, maxIterations, faults);
        EXPECT_EQ(faults, 0);
        return posterior;
    }

    /** Whether the linearisation, made near the prior's mean, still holds at a camera turned on from it. */
    [[nodiscard]] bool linearAfterTurn(double angle_rad) const
    {
        Eigen::VectorXd x = belief_.x;
        x.segment<4>(3) = quaternionExp({0.0, angle_rad, 0.0});
        return linearEnough(prediction_, pixels_, belief_, x, view_);
    }

    [[nodiscard]] Belief once() const { return ekfUpdate(belief_, prediction_, pixels_); }
    [[nodiscard]] double positionError_m(const Belief& posterior) const
    {
        return (posterior.x.head<3>() - truth_.head<3>()).norm();
    }

   private:
    /** At the mean that the first pixels give, as after the first stage of a search. */
    void linearizeByFirst(std::ptrdiff_t count)
    {
        const std::vector<PixelMeasurement> first(pixels_.begin(), pixels_.begin() + count);
        at_ = ekfUpdateMean(belief_, prediction_, first);
        Prediction again = predictAt(view_, belief_, at_);
        pixels_ = onRowsOf(again, prediction_, pixels_);
        prediction_ = std::move(again);
    }

    void add(LandmarkId id, double sigma_rho)
    {
        const Eigen::Vector3d ray(uniform(rng_, -0.5, 0.5), uniform(rng_, -0.4, 0.4), 1.0);
        const double rho = 1.0 + normalVector<1>(rng_, sigma_rho)[0];
        points_.push_back(ray.normalized() / std::max(rho, 0.2));
        if (id < kKnown)
        {
            belief_ = addPoint(std::move(belief_), id, points_.back(),
                               1e-10 * Eigen::Matrix3d::Identity());
            return;
        }
        const Eigen::Vector2d uv =
            *camera_.project(points_.back()) + normalVector<2>(rng_, kSigma_px);
        belief_ = *addUndelayed(std::move(belief_), camera_, id, uv, {1.0, sigma_rho, kSigma_px});
    }

    Eigen::Vector2d see(LandmarkId id)
    {
        const Eigen::Vector3d d = points_[static_cast<std::size_t>(id)] - truth_.head<3>();
        return *camera_.project(rotateInverse(truth_.tail<4>(), d)) +
               normalVector<2>(rng_, kSigma_px);
    }

    std::mt19937 rng_;
    Camera camera_{CameraParameters{}};
    Belief belief_;
    Vector7d truth_;
    std::vector<Eigen::Vector3d> points_;
    FrameView view_{[this](const Belief& belief) {
                        return predictMeasurements(belief, camera_, {0.0, kSigma_px});
                    },
                    [this](const Eigen::VectorXd& x, const LandmarkSlot& slot) {
                        return linearizeLandmark(x, slot, camera_, {0.0, kSigma_px});
                    },
                    {},
                    {},
                    0.0};
    Prediction prediction_;
    std::vector<PixelMeasurement> pixels_;
    Eigen::VectorXd at_;
};
}  // namespace

/** A parallax is the product of movement and depth: where twelve pixels put the camera is too far from
 *  where all of them do for one linearisation. */
TEST(IteratedUpdate, ComesToThePoseThatKnownPointsGive)
{
    double once_m = 0.0, iterated_m = 0.0;
    constexpr unsigned kRuns = 20;
    for (unsigned seed = 0; seed < kRuns; ++seed)
    {
        SecondFrame frame(0.4, seed);
        once_m += frame.positionError_m(frame.update(2)) / kRuns;
        iterated_m += frame.positionError_m(frame.update(kUnlimited)) / kRuns;
    }
    EXPECT_LT(iterated_m, 0.5 * once_m);
    EXPECT_LT(iterated_m, 1e-3);
}

TEST(IteratedUpdate, StopsWhenTheProjectionIsLinearWithinTheNoise)
{
    SecondFrame frame(0.4, 1);
    const Belief enough = frame.update(8);
    const Belief more = frame.update(kUnlimited);
    EXPECT_EQ(enough.x, more.x);
    EXPECT_NE(enough.x, frame.once().x);
}

TEST(IteratedUpdate, IsOneUpdateWhereThatIsEnough)
{
    SecondFrame known(1e-4, 2);
    EXPECT_EQ(known.update(kUnlimited).x, known.once().x);
    SecondFrame unknown(0.4, 2);
    EXPECT_EQ(unknown.update(2).x, unknown.once().x);
}

TEST(LinearEnough, HoldsForASmallTurnAndNotForALargeOne)
{
    const SecondFrame frame(1e-4, 1);
    EXPECT_TRUE(frame.linearAfterTurn(0.0));
    EXPECT_TRUE(frame.linearAfterTurn(0.005));
    EXPECT_FALSE(frame.linearAfterTurn(0.2));
}
}  // namespace monoslam
