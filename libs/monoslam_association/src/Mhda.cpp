// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "drawnParticles.h"
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/MhdaRule.h"
#include "monoslam_association/drawParents.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ConfigSection.h"
#include "particles.h"
#include "runInParallel.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
constexpr double kMostParticles = 64.0;

/** Options of [association.mhda]. */
struct MhdaOptions
{
    int particles = 2;
    Resampling resampling = Resampling::Multinomial;
    double neff_share = 0.65;  ///< of the particles, below which neff resamples
    int redraws = 4;  ///< times that all are drawn anew in a frame that none of them explains
    int threads = 1;
    LikelihoodOptions likelihood;
    MhdaRuleOptions rule;

    static MhdaOptions from(const IniFile& file, const std::string& fileName);
};

MhdaOptions MhdaOptions::from(const IniFile& file, const std::string& fileName)
{
    ConfigSection section(file, "association.mhda", fileName);
    MhdaOptions o;
    o.particles = section.get("particles", o.particles, {1.0, kMostParticles});
    o.likelihood = LikelihoodOptions::from(section);
    o.rule.weight_model = section.get<WeightModel>(
        "weight_model", o.rule.weight_model,
        {{"ratio", WeightModel::Ratio}, {"literal", WeightModel::Literal}});
    o.rule.association = section.get<AssociationChoice>(
        "association", o.rule.association,
        {{"sample", AssociationChoice::Sample}, {"map", AssociationChoice::Map}});
    o.rule.target = informationTargetFrom(section);
    o.resampling = section.get<Resampling>("resampling", o.resampling,
                                           {{"multinomial", Resampling::Multinomial},
                                            {"systematic", Resampling::Systematic},
                                            {"neff", Resampling::Neff}});
    o.neff_share = section.get("neff_share", o.neff_share, {1e-6, 1.0});
    o.redraws = section.get("redraws", o.redraws, {0.0, 1000.0});
    o.threads = section.get("threads", o.threads, {1.0, kMostParticles});
    section.rejectUnknownKeys();
    return o;
}

/** Without the beliefs, which are large. */
Mixture lineageOf(const Mixture& particles)
{
    Mixture lineage;
    for (const WeightedBelief& particle : particles)
        lineage.push_back({{}, particle.logWeight, particle.separation});
    return lineage;
}

/** Multiple hypotheses data association: particles with a belief and associations of their own,
 *  weighted by how well those explain the image, propagated from frame to frame.
 *
 * The weights of a frame are used in the next: resampling comes first, so that the answer bears the
 * posterior weights. It is the same as resampling at the end, for prediction is the same for equal
 * beliefs.
 *
 * A particle whose first pair is wrong finds hardly anything else. With few particles it now and
 * then happens to all of them in one frame. Then they are drawn again, as long as the heaviest finds
 * less than half of what it searches and no other reads the frame as it does, and the heaviest of
 * all draws go on: the number of samples follows their likelihood.
 * \see Fox, "Adapting the sample size in particle filters through KLD-sampling", IJRR 2003 */
class Mhda : public Associator
{
   public:
    Mhda(const BatchOptions& batch, const MhdaOptions& options)
        : maxMeasured_(batch.max_measured),
          gate_(chi2Limit(2, options.likelihood.p_search)),
          options_(options)
    {
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = t.appearance = true;
        t.multipleCandidates = options_.likelihood.max_candidates > 1;
        t.hypothesesWithinFrame = t.hypothesesBetweenFrames = options_.particles > 1;
        return t;
    }

    [[nodiscard]] bool updatesByEngine() const override { return false; }

    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& rng) const override
    {
        Correction correction;
        std::vector<std::size_t> parents;
        const Mixture particles = resample(std::move(predicted), parents, rng);
        std::vector<DrawnParticle> drawn = draw(particles, view, rng, correction.counters);
        for (int again = 0; again < options_.redraws && !isTrusted(drawn); ++again)
            for (DrawnParticle& one : draw(particles, view, rng, correction.counters))
                drawn.push_back(std::move(one));
        drawn = heaviestOf(std::move(drawn), particles.size());
        std::vector<std::size_t> origins;
        for (const DrawnParticle& one : drawn) origins.push_back(one.origin);
        correction.mixture = descend(lineageOf(particles), origins);
        for (std::size_t i = 0; i < drawn.size(); ++i)
        {
            correction.mixture[i].belief = std::move(drawn[i].outcome.belief);
            correction.mixture[i].logWeight = drawn[i].logWeight;
            correction.parents.push_back(parents[drawn[i].origin]);
        }
        age(correction.mixture);
        normalize(correction.mixture);
        collect(std::move(drawn), correction);
        correction.diversity = diversityOf(correction.mixture);
        return correction;
    }

   private:
    [[nodiscard]] SequentialSettings settings() const
    {
        return {gate_, options_.likelihood.max_candidates, maxMeasured_,
                options_.likelihood.min_zncc};
    }

    /** What becomes of every particle in the frame. */
    [[nodiscard]] std::vector<DrawnParticle> draw(const Mixture& particles, const FrameView& view,
                                                  std::mt19937& rng,
                                                  AssociationCounters& counters) const
    {
        std::vector<std::mt19937> streams;
        for (std::size_t i = 0; i < particles.size(); ++i) streams.emplace_back(rng());
        const CandidateLikelihood likelihood(options_.likelihood, view.imageArea_px2);
        std::vector<DrawnParticle> drawn(particles.size());
        counters.otherThreadsMs += runInParallel(
            particles.size(), options_.threads,
            [&](std::size_t i)
            {
                MhdaRule rule(options_.rule, likelihood, gate_, streams[i]);
                drawn[i].outcome = measureOneByOne(particles[i].belief, view, settings(), rule);
                drawn[i].origin = i;
                drawn[i].logWeight = particles[i].logWeight + rule.logWeight();
            });
        for (const DrawnParticle& one : drawn) addUp(one.outcome.counters, counters);
        return drawn;
    }

    /** Of all particles, those of the draws that are not kept too. */
    static void addUp(const AssociationCounters& one, AssociationCounters& sum)
    {
        sum.pixelsCorrelated += one.pixelsCorrelated;
        sum.searches += one.searches;
        sum.faults += one.faults;
        sum.searchMs += one.searchMs;
        sum.selectMs += one.selectMs;
        sum.updateMs += one.updateMs;
    }

    [[nodiscard]] Mixture resample(Mixture mixture, std::vector<std::size_t>& parents,
                                   std::mt19937& rng) const
    {
        if (mixture.empty()) throw std::logic_error("mhda: the mixture is empty");
        const auto count = static_cast<std::size_t>(options_.particles);
        parents =
            drawParents(weightsOf(mixture), count, options_.resampling, options_.neff_share, rng);
        if (!parents.empty()) return descend(std::move(mixture), parents);
        for (std::size_t i = 0; i < count; ++i)
        {
            parents.push_back(i);
            mixture[i].separation.resize(count, 0);
        }
        return mixture;
    }

    /** Pairs and rejected of the heaviest, whose associations are the answer's. */
    static void collect(std::vector<DrawnParticle> drawn, Correction& correction)
    {
        const std::size_t heaviest = bestIndex(correction.mixture);
        const AssociationCounters& best = drawn[heaviest].outcome.counters;
        correction.counters.pairs = best.pairs;
        correction.counters.rejected = best.rejected;
        for (DrawnParticle& one : drawn)
            correction.ofEveryBelief.push_back(std::move(one.outcome.associations));
        correction.associations = correction.ofEveryBelief[heaviest];
    }

    int maxMeasured_;
    double gate_;
    MhdaOptions options_;
};
}  // namespace

std::unique_ptr<Associator> makeMhda(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<Mhda>(BatchOptions::from(file, fileName),
                                  MhdaOptions::from(file, fileName));
}
}  // namespace monoslam
