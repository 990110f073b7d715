// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "monoslam_mrpt/RangeBearingKFSLAM.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
enum class Resampling
{
    Multinomial,  ///< each step, as the paper does
    Systematic,   ///< each step, with one random number
    Neff,         ///< systematic, when fewer than 65 % of the filters count
};

/** Options of ini section [RangeBearingKFSLAM_MHDA]. */
struct MONOSLAM_MRPT_EXPORT RangeBearingMhdaOptions
{
    int particles = 2;
    double p_detection = 0.9;  ///< of a landmark in view
    double clutter_density =
        3e-3;  ///< clutter and new landmarks: 1 / (m rad), in space 1 / (m rad^2)
    Resampling resampling = Resampling::Systematic;

    static RangeBearingMhdaOptions from(const mrpt::config::CConfigFileBase& ini);
};

/** Multiple hypotheses of data association, propagated (MHDA): P of MRPT's filters, each of which
 *  draws its associations, weighted by how well they explain the observations.
 *
 *      ln w += n_view ln(1 - P_D) + ln of the normalisers of what was drawn
 *
 * \tparam Slam  RangeBearingKFSLAM or RangeBearingKFSLAM2D */
template <class Slam>
class RangeBearingMhda
{
   public:
    explicit RangeBearingMhda(unsigned seed);
    ~RangeBearingMhda();
    RangeBearingMhda(const RangeBearingMhda&) = delete;
    RangeBearingMhda& operator=(const RangeBearingMhda&) = delete;

    /** The sections of Slam and [RangeBearingKFSLAM_MHDA]; the map is emptied. */
    void loadOptions(const mrpt::config::CConfigFileBase& ini);
    void reset();
    void processActionObservation(mrpt::obs::CActionCollection::Ptr& action,
                                  mrpt::obs::CSensoryFrame::Ptr& observations);

    /** The filter of largest weight, or one of those that were drawn in its place. */
    [[nodiscard]] const Slam& best() const;
    /** Of the filters, before they were last drawn anew; they add up to 1. */
    [[nodiscard]] const std::vector<double>& weights() const { return weights_; }

   private:
    class Particle;
    void resample(const std::vector<int>& children);
    [[nodiscard]] std::vector<int> drawChildren();

    RangeBearingMhdaOptions options_;
    unsigned seed_;
    std::mt19937 rng_;
    std::vector<std::unique_ptr<Particle>> particles_;
    std::vector<double> logWeights_, weights_;
    std::size_t best_ = 0;
};

extern template class MONOSLAM_MRPT_EXPORT RangeBearingMhda<RangeBearingKFSLAM>;
extern template class MONOSLAM_MRPT_EXPORT RangeBearingMhda<RangeBearingKFSLAM2D>;
}  // namespace monoslam
