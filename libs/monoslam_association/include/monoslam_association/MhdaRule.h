// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "monoslam_association/CandidateLikelihood.h"
#include "monoslam_association/MeasurementEfficiency.h"
#include "monoslam_association/measureOneByOne.h"

namespace monoslam
{
enum class WeightModel
{
    Ratio,    ///< relative to clutter: does not depend on how much was searched
    Literal,  ///< the paper's: Poisson clutter, uniform in each region
};

enum class AssociationChoice
{
    Sample,  ///< drawn with its probability; the weight is multiplied by the sum of all
    Map,     ///< the likeliest; the weight is multiplied by its likelihood
};

struct MhdaRuleOptions
{
    WeightModel weight_model = WeightModel::Ratio;
    AssociationChoice association = AssociationChoice::Sample;
    InformationTarget target = InformationTarget::State;
};

/** What one particle of MHDA does in one frame, and what that is worth.
 *
 * Landmarks are drawn with probability proportional to bits per searched area. Of a landmark's
 * candidates and "not found" one is chosen:
 *
 *      sample:  r ~ l_r / sum l,   w <- w sum l;       map:  r = argmax l,   w <- w l_r
 *
 * The literal model weighs the same choice by the paper's likelihood p: sample by p_r sum l / l_r,
 * map by p_r. \see Soto-Alvarez and Honkamaa, "Multiple hypotheses data association propagation for
 * robust monocular-based SLAM algorithms" */
class MONOSLAM_ASSOCIATION_EXPORT MhdaRule : public SequentialRule
{
   public:
    /** \param likelihood  must outlive this object */
    MhdaRule(const MhdaRuleOptions& options, const CandidateLikelihood& likelihood, double gate,
             const std::mt19937& rng);

    [[nodiscard]] std::optional<std::size_t> next(const SequentialUpdate& update) override;
    [[nodiscard]] int accept(const PredictedLandmark& landmark,
                             const std::vector<Candidate>& candidates) override;
    /** ln of the factor by which this frame multiplies the particle's weight. */
    [[nodiscard]] double logWeight() const;

   private:
    [[nodiscard]] std::size_t draw(const std::vector<double>& weights, double sum);
    [[nodiscard]] double logLiteral(const PredictedLandmark& landmark,
                                    const std::vector<Candidate>& candidates, int chosen) const;

    MhdaRuleOptions options_;
    const CandidateLikelihood& likelihood_;
    double gate_;
    std::mt19937 rng_;
    std::vector<MeasurementEfficiency> efficiencies_;
    std::vector<double> weights_;
    double logWeight_ = 0.0;
    long clutter_ = 0;  ///< candidates that were not chosen
};
}  // namespace monoslam
