// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RangeBearingMhda.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawAssignment.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
constexpr double kEnoughFilters = 0.65;

double uniform(std::mt19937& rng)
{
    return static_cast<double>(rng()) / 4294967296.0;
}
}  // namespace

RangeBearingMhdaOptions RangeBearingMhdaOptions::from(const mrpt::config::CConfigFileBase& ini)
{
    RangeBearingMhdaOptions o;
    ConfigSection section(ini, "RangeBearingKFSLAM_MHDA");
    o.particles = section.get("particles", o.particles, {1.0, 1e4});
    o.p_detection = section.get("p_detection", o.p_detection, {1e-6, 1.0 - 1e-6});
    o.clutter_density = section.get("clutter_density", o.clutter_density, kPositive);
    o.resampling = section.get<Resampling>("resampling", o.resampling,
                                           {{"multinomial", Resampling::Multinomial},
                                            {"systematic", Resampling::Systematic},
                                            {"neff", Resampling::Neff}});
    section.rejectUnknownKeys();
    return o;
}

/** A filter that draws its associations. */
template <class Slam>
class RangeBearingMhda<Slam>::Particle : public Slam
{
   public:
    explicit Particle(const RangeBearingMhdaOptions& mhda)
        : model_{mhda.p_detection, mhda.clutter_density}
    {
    }

    void restart(unsigned seed)
    {
        Slam::reset();
        rng_.seed(seed);
    }

    /** \return what the step adds to the logarithm of the weight */
    double process(mrpt::obs::CActionCollection::Ptr& action,
                   mrpt::obs::CSensoryFrame::Ptr& observations)
    {
        logWeight_ = 0.0;
        Slam::processActionObservation(action, observations);
        return logWeight_;
    }

   private:
    AssignmentResult choose(const AssignmentProblem& problem, long inView) override
    {
        DrawnAssignment drawn = drawAssignment(problem, model_, rng_);
        logWeight_ =
            drawn.logWeight + static_cast<double>(inView) * std::log1p(-model_.p_detection);
        return std::move(drawn.assignment);
    }

    DetectionModel model_;
    std::mt19937 rng_;
    double logWeight_ = 0.0;
};

template <class Slam>
RangeBearingMhda<Slam>::RangeBearingMhda(unsigned seed) : seed_(seed)
{
    loadOptions(mrpt::config::CConfigFileMemory(""));
}

template <class Slam>
RangeBearingMhda<Slam>::~RangeBearingMhda() = default;

template <class Slam>
void RangeBearingMhda<Slam>::loadOptions(const mrpt::config::CConfigFileBase& ini)
{
    options_ = RangeBearingMhdaOptions::from(ini);
    particles_.clear();
    for (int k = 0; k < options_.particles; ++k)
    {
        particles_.push_back(std::make_unique<Particle>(options_));
        particles_.back()->loadOptions(ini);
    }
    reset();
}

template <class Slam>
void RangeBearingMhda<Slam>::reset()
{
    rng_.seed(seed_);
    for (auto& particle : particles_) particle->restart(static_cast<unsigned>(rng_()));
    logWeights_.assign(particles_.size(), 0.0);
    weights_.assign(particles_.size(), 1.0 / static_cast<double>(particles_.size()));
    best_ = 0;
}

template <class Slam>
const Slam& RangeBearingMhda<Slam>::best() const
{
    return *particles_[best_];
}

template <class Slam>
void RangeBearingMhda<Slam>::processActionObservation(mrpt::obs::CActionCollection::Ptr& action,
                                                      mrpt::obs::CSensoryFrame::Ptr& observations)
{
    for (std::size_t k = 0; k < particles_.size(); ++k)
        logWeights_[k] += particles_[k]->process(action, observations);
    const double largest = *std::max_element(logWeights_.begin(), logWeights_.end());
    double sum = 0.0;
    for (double& l : logWeights_) sum += std::exp(l -= largest);
    for (std::size_t k = 0; k < weights_.size(); ++k) weights_[k] = std::exp(logWeights_[k]) / sum;
    best_ = static_cast<std::size_t>(std::max_element(weights_.begin(), weights_.end()) -
                                     weights_.begin());

    const double squares =
        std::inner_product(weights_.begin(), weights_.end(), weights_.begin(), 0.0);
    const auto P = static_cast<double>(particles_.size());
    if (options_.resampling != Resampling::Neff || 1.0 / squares < kEnoughFilters * P)
        resample(drawChildren());
}

template <class Slam>
std::vector<int> RangeBearingMhda<Slam>::drawChildren()
{
    const std::size_t P = particles_.size();
    const bool multinomial = options_.resampling == Resampling::Multinomial;
    std::vector<int> children(P, 0);
    const double offset = uniform(rng_);
    for (std::size_t draw = 0; draw < P; ++draw)
    {
        double at = multinomial ? uniform(rng_)
                                : (static_cast<double>(draw) + offset) / static_cast<double>(P);
        std::size_t k = 0;
        while (k + 1 < P && (at -= weights_[k]) >= 0.0) ++k;
        ++children[k];
    }
    return children;
}

/** Filters without children become copies of those with several; the best stays where it is if it
 *  has any. */
template <class Slam>
void RangeBearingMhda<Slam>::resample(const std::vector<int>& children)
{
    std::vector<std::size_t> surplus;
    for (std::size_t k = 0; k < children.size(); ++k)
        for (int copy = 1; copy < children[k]; ++copy) surplus.push_back(k);
    for (std::size_t k = 0; k < children.size(); ++k)
    {
        if (children[k] > 0) continue;
        particles_[k]->copyStateFrom(*particles_[surplus.back()]);
        surplus.pop_back();
    }
    std::fill(logWeights_.begin(), logWeights_.end(), 0.0);
}

template class RangeBearingMhda<RangeBearingKFSLAM>;
template class RangeBearingMhda<RangeBearingKFSLAM2D>;
}  // namespace monoslam
