// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_association/Associator.h"
#include "monoslam_association/export.h"

namespace monoslam
{
class ConfigSection;

/** How likely landmarks are found and wrong candidates met. */
struct MONOSLAM_ASSOCIATION_EXPORT ClutterOptions
{
    double p_present = 0.9;           ///< that a landmark in view can be seen
    double p_search = 0.95;           ///< that it then lies in its ellipse: sets the gate
    double clutter_per_image = 20.0;  ///< N_C: wrong candidates of one template, Poisson
    double min_zncc = 0.7;            ///< least score of a candidate
    int max_candidates = 5;           ///< of a landmark

    /** Reads the keys above; the caller rejects unknown ones. */
    static ClutterOptions from(ConfigSection& section);
};

/** And what scores right candidates have. */
struct MONOSLAM_ASSOCIATION_EXPORT LikelihoodOptions : ClutterOptions
{
    double score_decay = 12.0;  ///< lambda: right scores fall like exp(-lambda (1 - score))

    /** Reads the keys above; the caller rejects unknown ones. */
    static LikelihoodOptions from(ConfigSection& section);
};

/** Likelihoods of what a landmark's search brought, relative to all of it being clutter.
 *
 *      l_c = P_present N(z_c; h, S) a(s_c) / beta,   l_0 = 1 - P_present P_search
 *      beta = N_C / image area,   a(s) = p(s | right) / p(s | wrong)
 *
 * P_present N is P_D = P_present P_search times the Gaussian cut off at the gate. Scores of right
 * candidates fall exponentially from 1, those of wrong ones are uniform, both on [min_zncc, 1].
 * As ratios, what was searched in vain or not at all weighs the same however large it is.
 * \see Vermaak, Godsill, Perez, "Monte Carlo filtering for multi-target tracking and data
 *      association", 2005 */
class MONOSLAM_ASSOCIATION_EXPORT CandidateLikelihood
{
   public:
    CandidateLikelihood(const LikelihoodOptions& options, double imageArea_px2);

    /** ln l_c; S of the landmark's row, with the candidate's noise in the place of the row's. */
    [[nodiscard]] double logFound(const PredictedLandmark& landmark,
                                  const Candidate& candidate) const;
    /** ln N(z; h, S) [1/px^2] */
    [[nodiscard]] static double logDensity(const Eigen::Vector2d& nu, const Eigen::Matrix2d& S);
    /** ln a(s) */
    [[nodiscard]] double logScoreRatio(double score) const;
    [[nodiscard]] double logMissed() const { return logMissed_; }
    /** ln P_D */
    [[nodiscard]] double logDetection() const;
    [[nodiscard]] const LikelihoodOptions& options() const { return options_; }

   private:
    LikelihoodOptions options_;
    double logBeta_;
    double logMissed_;
    double logScoreScale_;
};
}  // namespace monoslam
