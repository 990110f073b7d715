// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "monoslam_eval/SyntheticWorld.h"
#include "monoslam_eval/consistency.h"
#include "monoslam_eval/drawMotion.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_filter/secondOrderNoise.h"

namespace monoslam
{
struct SyntheticRunOptions
{
    bool delayed = true;       ///< DI-D with clones, else undelayed
    bool target = true;        ///< metric start: four known points, 0.4 m x 0.3 m at 1 m
    bool secondOrder = false;  ///< secondOrderNoise() is added to each pixel's R
    double dt_s = 1.0 / 30.0;
    ConstantVelocityOptions motion{NoiseForm::Density, 0.1, 0.1};
    double sigma_px = 0.5;
    std::size_t features = 40;  ///< visible landmarks and candidates together
    double nearest_m = 1.0;     ///< delayed: inverse depth uniform in [1/farthest, 1/nearest]
    double farthest_m = 5.0;
    UndelayedPrior prior{0.5, 0.25, 0.5};  ///< undelayed: true inverse depth drawn from it, > 0
    double sigma_r = 0.005, sigma_theta = 0.005;  ///< first pose [m], [rad]
    double sigma_v = 0.1, sigma_omega = 0.1;      ///< first velocities [m/s], [rad/s]
    double minParallax_rad = 5.0 * 3.14159265358979323846 / 180.0;
};

/** Known association in a SyntheticWorld with the filter's own process model: what remains of the
 *  NEES above its expectation is linearisation. */
class SyntheticRun
{
   public:
    SyntheticRun(const SyntheticRunOptions& options, unsigned seed)
        : options_(options), world_(worldOptions(options), seed)
    {
        options_.prior.sigma_px = options.sigma_px;
        Vector13d x_v = Vector13d::Zero();
        x_v[camera_state::kOrientation] = 1.0;
        Matrix13d P_v = Matrix13d::Zero();
        const double sigma_q = 0.5 * options.sigma_theta;  // q = (1, theta / 2)
        P_v.diagonal() << Eigen::Vector3d::Constant(std::pow(options.sigma_r, 2)), 0.0,
            Eigen::Vector3d::Constant(sigma_q * sigma_q),
            Eigen::Vector3d::Constant(std::pow(options.sigma_v, 2)),
            Eigen::Vector3d::Constant(std::pow(options.sigma_omega, 2));
        belief_ = Belief::ofCamera(x_v, P_v);
        truth_ = drawCamera(x_v, P_v, world_.rng());
        if (options.target) addTarget();
        grow();
    }

    /** One frame: predict, correct with every landmark in view, manage the map.
     *  \return NEES of the camera pose, 6 numbers */
    double step()
    {
        ++frame_;
        truth_ = drawMotion(truth_, options_.dt_s, options_.motion, world_.rng());
        belief_ = ekfPredict(std::move(belief_), options_.motion, options_.dt_s);
        correct();
        const double value = poseNees();
        promote();
        forget();
        grow();
        return value;
    }

   private:
    struct Tracked
    {
        LandmarkId id;
        CloneId clone;
        Eigen::Vector2d uv0;
    };

    static SyntheticWorldOptions worldOptions(const SyntheticRunOptions& options)
    {
        SyntheticWorldOptions world;
        world.sigma_px = options.sigma_px;
        return world;
    }

    void addTarget()
    {
        constexpr double sigma_m = 0.001;
        std::normal_distribution<double> normal;
        for (const double x : {-0.2, 0.2})
            for (const double y : {-0.15, 0.15})
            {
                const Eigen::Vector3d p(x, y, 1.0);
                Eigen::Vector3d noise;
                for (double& n : noise) n = sigma_m * normal(world_.rng());
                const LandmarkId id = world_.addLandmark(p + noise);
                belief_ = addPoint(std::move(belief_), id, p,
                                   sigma_m * sigma_m * Eigen::Matrix3d::Identity());
            }
    }

    void correct()
    {
        const Prediction prediction =
            predictMeasurements(belief_, world_.camera(), {-50.0, options_.sigma_px});
        std::vector<PixelMeasurement> pixels;
        for (Eigen::Index row = 0; row < prediction.count(); ++row)
        {
            const PredictedLandmark& p = prediction.rows[static_cast<std::size_t>(row)];
            const auto z = world_.measure(truth_, p.id);
            if (!z) continue;
            Eigen::Matrix2d R = p.R;
            if (options_.secondOrder) R += secondOrderNoise(belief_, world_.camera(), p);
            pixels.push_back({row, *z, R});
        }
        belief_ = ekfUpdate(std::move(belief_), prediction, pixels);
    }

    [[nodiscard]] double poseNees() const
    {
        const auto stamped = [](const Vector13d& x_v) {
            return StampedPose{0.0, x_v.head<3>(), x_v.segment<4>(camera_state::kOrientation)};
        };
        const Matrix6d P = poseErrorCovariance(belief_.pose(), belief_.P);
        return nees(poseError(stamped(belief_.camera()), stamped(truth_)), P)
            .value_or(std::nan(""));
    }

    void promote()
    {
        std::vector<Tracked> waiting;
        for (const Tracked& tracked : tracked_)
        {
            const auto uv = world_.measure(truth_, tracked.id);
            if (!uv) continue;
            const Vector7d pose0 = belief_.clonePose(*belief_.findClone(tracked.clone));
            const auto t =
                triangulate(world_.camera(), {pose0, tracked.uv0}, {belief_.pose(), *uv});
            if (t && t->alpha_rad >= options_.minParallax_rad)
                belief_ =
                    addTriangulated(std::move(belief_), tracked.id, *t,
                                    {tracked.clone, {}, {}, tracked.uv0}, options_.sigma_px, 0.0);
            else
                waiting.push_back(tracked);
        }
        tracked_ = std::move(waiting);
    }

    /** Landmarks out of view and clones without candidates leave the state. */
    void forget()
    {
        std::vector<LandmarkId> gone;
        for (const LandmarkSlot& slot : belief_.landmarks)
            if (!world_.truePixel(truth_, slot.id)) gone.push_back(slot.id);
        belief_ = removeLandmarks(std::move(belief_), gone);
        std::vector<CloneId> unused;
        for (const CloneSlot& slot : belief_.clones)
            if (std::none_of(tracked_.begin(), tracked_.end(),
                             [&](const Tracked& t) { return t.clone == slot.id; }))
                unused.push_back(slot.id);
        belief_ = removeClones(std::move(belief_), unused);
    }

    void grow()
    {
        constexpr double border_px = 10.0;
        const bool due = frame_ % 5 == 0;  // so that clones are shared
        const std::size_t have = belief_.landmarks.size() + tracked_.size();
        if (!due || have >= options_.features) return;
        if (options_.delayed) belief_ = addClone(std::move(belief_), frame_);
        for (std::size_t i = have; i < options_.features; ++i)
        {
            const LandmarkId id = world_.addLandmarkInView(truth_, drawRho(), border_px);
            const Eigen::Vector2d uv = *world_.measure(truth_, id);
            if (options_.delayed)
                tracked_.push_back({id, frame_, uv});
            else
                belief_ = addUndelayed(belief_, world_.camera(), id, uv, options_.prior).value();
        }
    }

    double drawRho()
    {
        if (options_.delayed)
            return std::uniform_real_distribution<double>(1.0 / options_.farthest_m,
                                                          1.0 / options_.nearest_m)(world_.rng());
        std::normal_distribution<double> prior(options_.prior.rho0, options_.prior.sigma_rho);
        double rho = 0.0;
        while (rho < 0.01) rho = prior(world_.rng());
        return rho;
    }

    SyntheticRunOptions options_;
    SyntheticWorld world_;
    Belief belief_;
    Vector13d truth_;
    std::vector<Tracked> tracked_;
    std::int64_t frame_ = 0;
};
}  // namespace monoslam
