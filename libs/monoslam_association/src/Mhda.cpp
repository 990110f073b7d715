// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

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
    o.threads = section.get("threads", o.threads, {1.0, kMostParticles});
    section.rejectUnknownKeys();
    return o;
}

/** Multiple hypotheses data association: particles with a belief and associations of their own,
 *  weighted by how well those explain the image, propagated from frame to frame.
 *
 * The weights of a frame are used in the next: resampling comes first, so that the answer bears the
 * posterior weights. It is the same as resampling at the end, for prediction is the same for equal
 * beliefs. */
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
        correction.mixture = resample(std::move(predicted), correction.parents, rng);
        Mixture& particles = correction.mixture;
        std::vector<std::mt19937> streams;
        for (std::size_t i = 0; i < particles.size(); ++i) streams.emplace_back(rng());

        const CandidateLikelihood likelihood(options_.likelihood, view.imageArea_px2);
        std::vector<SequentialOutcome> outcomes(particles.size());
        const double others_ms =
            runInParallel(particles.size(), options_.threads,
                          [&](std::size_t i)
                          {
                              MhdaRule rule(options_.rule, likelihood, gate_, streams[i]);
                              outcomes[i] = measureOneByOne(std::move(particles[i].belief), view,
                                                            settings(), rule);
                              particles[i].belief = std::move(outcomes[i].belief);
                              particles[i].logWeight += rule.logWeight();
                          });
        age(particles);
        normalize(particles);
        collect(std::move(outcomes), correction);
        correction.counters.otherThreadsMs = others_ms;
        correction.diversity = diversityOf(particles);
        return correction;
    }

   private:
    [[nodiscard]] SequentialSettings settings() const
    {
        return {gate_, options_.likelihood.max_candidates, maxMeasured_,
                options_.likelihood.min_zncc};
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

    /** Counters of all particles added up; pairs and rejected of the heaviest, whose associations
     *  are the answer's. */
    static void collect(std::vector<SequentialOutcome> outcomes, Correction& correction)
    {
        const std::size_t heaviest = bestIndex(correction.mixture);
        AssociationCounters& sum = correction.counters;
        for (std::size_t i = 0; i < outcomes.size(); ++i)
        {
            const AssociationCounters& one = outcomes[i].counters;
            sum.pixelsCorrelated += one.pixelsCorrelated;
            sum.searches += one.searches;
            sum.faults += one.faults;
            sum.searchMs += one.searchMs;
            sum.selectMs += one.selectMs;
            sum.updateMs += one.updateMs;
            correction.ofEveryBelief.push_back(std::move(outcomes[i].associations));
        }
        sum.pairs = outcomes[heaviest].counters.pairs;
        sum.rejected = outcomes[heaviest].counters.rejected;
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
