// SPDX-License-Identifier: BSD-3-Clause
#include "Method.h"

#include <mrpt/config/CConfigFileMemory.h>

namespace monoslam
{
namespace
{
const std::vector<int> kParticles{1, 2, 4, 8, 16};

/** Hypotheses within a frame as another strategy has them, but none between frames. */
class HeaviestOnly : public Associator
{
   public:
    explicit HeaviestOnly(std::unique_ptr<Associator> whole) : whole_(std::move(whole)) {}

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits traits = whole_->traits();
        traits.hypothesesBetweenFrames = false;
        return traits;
    }

    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& rng) const override
    {
        Correction correction = whole_->correct(std::move(predicted), view, rng);
        Belief heaviest = std::move(best(correction.mixture));
        correction.mixture.clear();
        correction.mixture.push_back({std::move(heaviest)});
        correction.ofEveryBelief.clear();
        correction.parents.clear();
        return correction;
    }

   private:
    std::unique_ptr<Associator> whole_;
};

/** As the second paper has it: it is its claim that is tested. */
const std::string kDrawnOnce = "redraws = 0\n";

Method mhdaWith(int particles, const std::string& scheme)
{
    const std::string P = std::to_string(particles);
    return {"P = " + P + ", " + scheme, "mhda",
            kDrawnOnce + "particles = " + P + "\nresampling = " + scheme + "\n"};
}
}  // namespace

std::shared_ptr<const Associator> Method::make() const
{
    const mrpt::config::CConfigFileMemory ini("[association." + strategy + "]\n" + options);
    auto associator = makeAssociator(strategy, ini, name);
    if (!heaviestOnly) return associator;
    return std::make_shared<HeaviestOnly>(std::move(associator));
}

std::vector<Method> allStrategies()
{
    std::vector<Method> methods;
    for (const std::string& name : associatorNames())
        methods.push_back({name, name, name == "mhda" ? kDrawnOnce : ""});
    return methods;
}

std::vector<Method> mhdaVariants()
{
    std::vector<Method> methods;
    for (const std::string scheme : {"multinomial", "systematic", "neff"})
        for (const int particles : kParticles) methods.push_back(mhdaWith(particles, scheme));
    for (const int particles : kParticles)
    {
        if (particles == 1) continue;
        methods.push_back(mhdaWith(particles, "multinomial"));
        methods.back().name = "P = " + std::to_string(particles) + ", heaviest only";
        methods.back().heaviestOnly = true;
    }
    return methods;
}
}  // namespace monoslam
