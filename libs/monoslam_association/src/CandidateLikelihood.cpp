// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/CandidateLikelihood.h"

#include <Eigen/LU>
#include <cmath>

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
ClutterOptions ClutterOptions::from(ConfigSection& section)
{
    const Range probability{1e-6, 1.0 - 1e-9};
    ClutterOptions o;
    o.p_present = section.get("p_present", o.p_present, probability);
    o.p_search = section.get("p_search", o.p_search, probability);
    o.clutter_per_image = section.get("clutter_per_image", o.clutter_per_image, {1e-6, 1e6});
    o.min_zncc = section.get("min_zncc", o.min_zncc, {-1.0, 1.0 - 1e-6});
    o.max_candidates = section.get("max_candidates", o.max_candidates, {1.0, 100.0});
    return o;
}

LikelihoodOptions LikelihoodOptions::from(ConfigSection& section)
{
    LikelihoodOptions o;
    static_cast<ClutterOptions&>(o) = ClutterOptions::from(section);
    o.score_decay = section.get("score_decay", o.score_decay, {1e-6, 1e3});
    return o;
}

CandidateLikelihood::CandidateLikelihood(const LikelihoodOptions& options, double imageArea_px2)
    : options_(options),
      logBeta_(std::log(options.clutter_per_image / imageArea_px2)),
      logMissed_(std::log1p(-options.p_present * options.p_search))
{
    const double range = 1.0 - options.min_zncc;
    const double decay = options.score_decay;
    logScoreScale_ = std::log(decay * range) - std::log(-std::expm1(-decay * range));
}

double CandidateLikelihood::logDensity(const Eigen::Vector2d& nu, const Eigen::Matrix2d& S)
{
    return -std::log(2.0 * M_PI) - 0.5 * std::log(S.determinant()) - 0.5 * nu.dot(S.inverse() * nu);
}

double CandidateLikelihood::logScoreRatio(double score) const
{
    return logScoreScale_ - options_.score_decay * (1.0 - score);
}

double CandidateLikelihood::logDetection() const
{
    return std::log(options_.p_present * options_.p_search);
}

double CandidateLikelihood::logFound(const PredictedLandmark& landmark,
                                     const Candidate& candidate) const
{
    const Eigen::Matrix2d S = landmark.S - landmark.R + candidate.R;
    return std::log(options_.p_present) + logDensity(candidate.z - landmark.h, S) +
           logScoreRatio(candidate.score) - logBeta_;
}
}  // namespace monoslam
