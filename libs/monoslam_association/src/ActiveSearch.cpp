// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/MeasurementEfficiency.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/measureOneByOne.h"
#include "monoslam_support/ConfigSection.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** Options of [association.active_search]. */
struct ActiveSearchOptions
{
    double stop_bits = 0.1;  ///< the frame is done when no landmark tells as much
    InformationTarget target = InformationTarget::State;

    static ActiveSearchOptions from(const IniFile& file, const std::string& fileName);
};

ActiveSearchOptions ActiveSearchOptions::from(const IniFile& file, const std::string& fileName)
{
    ConfigSection section(file, "association.active_search", fileName);
    ActiveSearchOptions o;
    o.stop_bits = section.get("stop_bits", o.stop_bits, {0.0, 1e3});
    o.target = informationTargetFrom(section);
    section.rejectUnknownKeys();
    return o;
}

/** Of the landmarks that tell enough the most efficient one; its best-looking candidate. */
class GreedyRule : public SequentialRule
{
   public:
    GreedyRule(const ActiveSearchOptions& options, double gate) : options_(options), gate_(gate) {}

    std::optional<std::size_t> next(const SequentialUpdate& update) override
    {
        listEfficiencies(update, options_.target, gate_, list_);
        const MeasurementEfficiency* best = nullptr;
        for (const MeasurementEfficiency& entry : list_)
            if (entry.bits >= options_.stop_bits &&
                (best == nullptr || entry.bitsPerPixel2 > best->bitsPerPixel2))
                best = &entry;
        if (best == nullptr) return std::nullopt;
        return best->landmark;
    }

    int accept(const PredictedLandmark&, const std::vector<Candidate>& candidates) override
    {
        return candidates.empty() ? -1 : 0;
    }

   private:
    const ActiveSearchOptions& options_;
    double gate_;
    std::vector<MeasurementEfficiency> list_;
};

/** Active Search: most efficient landmark first, update after each, no way back.
 *  \see Davison, "Active search for real-time vision", ICCV 2005 */
class ActiveSearch : public Associator
{
   public:
    ActiveSearch(const BatchOptions& batch, const ActiveSearchOptions& options)
        : maxMeasured_(batch.max_measured),
          gate_(chi2Limit(2, batch.gate_probability)),
          options_(options)
    {
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.appearance = true;
        return t;
    }

    [[nodiscard]] bool updatesByEngine() const override { return false; }

    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& /*rng*/) const override
    {
        Belief& belief = onlyBelief(predicted);
        GreedyRule rule(options_, gate_);
        SequentialOutcome outcome =
            measureOneByOne(std::move(belief), view, {gate_, 1, maxMeasured_, {}}, rule);
        belief = std::move(outcome.belief);
        return {std::move(predicted), std::move(outcome.associations), outcome.counters};
    }

   private:
    int maxMeasured_;
    double gate_;
    ActiveSearchOptions options_;
};
}  // namespace

std::unique_ptr<Associator> makeActiveSearch(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<ActiveSearch>(BatchOptions::from(file, fileName),
                                          ActiveSearchOptions::from(file, fileName));
}
}  // namespace monoslam
