// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/FeatureSlam.h"

#include <algorithm>
#include <stdexcept>

#include "monoslam_filter/ekf.h"
#include "monoslam_filter/linearLandmarks.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
Belief firstBelief(const FeatureSlamOptions& options)
{
    Vector13d x_v = Vector13d::Zero();
    x_v[camera_state::kOrientation] = 1.0;
    Matrix13d P_v = Matrix13d::Zero();
    P_v.diagonal()
        .segment<3>(camera_state::kVelocity)
        .setConstant(options.sigma_v_mps * options.sigma_v_mps);
    P_v.diagonal()
        .segment<3>(camera_state::kAngularVelocity)
        .setConstant(options.sigma_omega_radps * options.sigma_omega_radps);
    Belief belief = Belief::ofCamera(x_v, P_v);
    const double variance = options.target.sigma_m * options.target.sigma_m;
    LandmarkId id = 0;
    for (const Eigen::Vector3d& p : options.target.points())
        belief = addPoint(std::move(belief), id++, p, variance * Eigen::Matrix3d::Identity());
    return belief;
}
}  // namespace

FeatureSlamOptions FeatureSlamOptions::from(const mrpt::config::CConfigFileBase& file,
                                            const std::string& fileName)
{
    FeatureSlamOptions o;
    o.motion = ConstantVelocityOptions::from({file, "motion", fileName});
    o.target = TargetOptions::from({file, "target", fileName});
    ConfigSection section(file, "slam", fileName);
    o.visibility.border_px = section.get("border_px", o.visibility.border_px, {0.0, 1e4});
    o.visibility.sigma_px = section.get("sigma_px", o.visibility.sigma_px, kPositive);
    o.prior.sigma_px = o.visibility.sigma_px;
    o.prior.rho0 = section.get("rho0_per_m", o.prior.rho0, kPositive);
    o.prior.sigma_rho = section.get("sigma_rho_per_m", o.prior.sigma_rho, kPositive);
    o.sigma_v_mps = section.get("sigma_v_mps", o.sigma_v_mps, kPositive);
    o.sigma_omega_radps = section.get("sigma_omega_radps", o.sigma_omega_radps, kPositive);
    o.convert_linearity = section.get("convert_linearity", o.convert_linearity, {0.0, 10.0});
    section.rejectUnknownKeys();
    return o;
}

FeatureSlam::FeatureSlam(const FeatureSlamOptions& options, const Camera& camera,
                         std::shared_ptr<const Associator> associator, unsigned seed)
    : options_(options), camera_(camera), associator_(std::move(associator)), rng_(seed)
{
    mixture_.push_back({firstBelief(options)});
}

void FeatureSlam::use(std::shared_ptr<const Associator> associator)
{
    associator_ = std::move(associator);
}

void FeatureSlam::check(const PixelFrame& frame) const
{
    const std::string where = "frame at " + std::to_string(frame.t_s) + " s: ";
    if (t_s_ && !(frame.t_s > *t_s_))
        throw std::invalid_argument(where + "not after the one before it");
    for (const PixelFeature& feature : frame.features)
        if (feature.truth == kUnknownTruth)
            throw std::invalid_argument(where + "the truth of feature " +
                                        std::to_string(feature.id) +
                                        " is unknown; no landmark can begin with it");
}

Mixture FeatureSlam::predict(Mixture mixture, double t_s) const
{
    if (!t_s_) return mixture;
    for (WeightedBelief& weighted : mixture)
        weighted.belief = ekfPredict(std::move(weighted.belief), options_.motion, t_s - *t_s_);
    return mixture;
}

Mixture FeatureSlam::grow(Mixture mixture, const PixelFrame& frame) const
{
    for (WeightedBelief& weighted : mixture)
    {
        std::vector<NewLandmark> corners;
        for (const PixelFeature& feature : frame.features)
        {
            if (feature.truth >= 0 && weighted.belief.find(feature.truth) < 0 &&
                camera_.contains(feature.z, options_.visibility.border_px))
                corners.push_back({feature.truth, feature.z});
        }
        if (!corners.empty())
            weighted.belief =
                addUndelayed(std::move(weighted.belief), camera_, corners, options_.prior);
        const auto linear = linearLandmarks(weighted.belief, options_.convert_linearity);
        weighted.belief = convertToPoints(std::move(weighted.belief), linear);
    }
    return mixture;
}

FeatureReport FeatureSlam::report(double t_s, Correction correction) const
{
    const Belief& belief = best(mixture_);
    FeatureReport report;
    report.t_s = t_s;
    report.x_v = belief.camera();
    report.P_v = belief.P.topLeftCorner<camera_state::kSize, camera_state::kSize>();
    report.landmarks = static_cast<int>(belief.landmarks.size());
    report.associations = std::move(correction.associations);
    report.counters = correction.counters;
    report.diversity = correction.diversity;
    return report;
}

FeatureReport FeatureSlam::process(const PixelFrame& frame)
{
    check(frame);
    Mixture predicted = predict(std::move(mixture_), frame.t_s);
    t_s_ = frame.t_s;
    Correction correction = associator_->correct(std::move(predicted),
                                                 viewOf(frame, camera_, options_.visibility), rng_);
    mixture_ = grow(std::move(correction.mixture), frame);
    return report(frame.t_s, std::move(correction));
}
}  // namespace monoslam
