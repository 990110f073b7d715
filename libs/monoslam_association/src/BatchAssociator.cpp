// SPDX-License-Identifier: BSD-3-Clause
#include <ctime>
#include <stdexcept>

#include "BatchSearch.h"
#include "ConditionalPrediction.h"
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
double threadTime_ms()
{
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/** Time since the last lap. */
class LapClock
{
   public:
    void lap(double& total_ms)
    {
        const double now_ms = threadTime_ms();
        total_ms += now_ms - last_ms_;
        last_ms_ = now_ms;
    }

   private:
    double last_ms_ = threadTime_ms();
};

/** Whether the update can factorise S, after the one inflation that it tries. */
bool updatable(const Prediction& prediction, std::vector<PixelMeasurement> pixels, double& d2)
{
    for (const double inflation : {1.0, 1.1})
    {
        for (PixelMeasurement& pixel : pixels) pixel.R *= inflation;
        const ConditionalPrediction accepted(prediction, pixels);
        if (!accepted.valid()) continue;
        d2 = accepted.d2();
        return true;
    }
    return false;
}

/** Fate, pixel, score and NIS of every pair that went into validation. */
void record(const AssociationProblem& problem, const std::vector<int>& chosen,
            std::vector<Association>& associations)
{
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        const auto row = static_cast<std::size_t>(problem.rows[i]);
        const auto index = static_cast<std::size_t>(std::max(chosen[i], 0));
        const Candidate& candidate = problem.candidates[i][index];
        Association& association = associations[row];
        association.fate = chosen[i] < 0 ? Fate::Rejected : Fate::Matched;
        association.z = candidate.z;
        association.R = candidate.R;
        association.score = candidate.score;
        const PixelMeasurement pixel{problem.rows[i], candidate.z, candidate.R};
        association.nis = ConditionalPrediction(*problem.prediction, {pixel}).d2();
    }
}
}  // namespace

BatchAssociator::BatchAssociator(const BatchOptions& options)
    : options_(options),
      gate_(chi2Limit(2, options.gate_probability)),
      finalGate_(chi2Limit(2, options.final_gate_probability))
{
}

std::vector<int> BatchAssociator::decide(const AssociationProblem& problem,
                                         AssociationCounters& counters) const
{
    if (problem.rows.empty()) return {};
    std::vector<int> chosen = select(problem, counters);
    if (validatesJointly() && options_.final_gate_probability < 1.0)
        applyFinalGate(problem, finalGate_, chosen);
    return chosen;
}

std::vector<int> BatchAssociator::choose(BatchSearch& search) const
{
    LapClock clock;
    AssociationCounters& counters = search.counters;
    search.searchFirstStage();
    clock.lap(counters.searchMs);
    const std::vector<int> first = decide(search.problem(), counters);
    clock.lap(counters.selectMs);
    search.searchRest(first);
    clock.lap(counters.searchMs);

    const AssociationProblem& problem = search.problem();
    std::vector<int> chosen =
        problem.rows.size() == first.size() ? first : decide(problem, counters);
    const auto pixels = pixelsOf(problem, chosen);
    if (!pixels.empty() && !updatable(*problem.prediction, pixels, counters.jointD2))
    {
        ++counters.faults;
        chosen.assign(chosen.size(), -1);
    }
    record(problem, chosen, search.associations);
    clock.lap(counters.selectMs);
    return chosen;
}

Correction BatchAssociator::correct(Mixture predicted, const FrameView& view,
                                    std::mt19937& /*rng*/) const
{
    if (predicted.size() != 1)
        throw std::logic_error("BatchAssociator: the mixture must hold exactly one belief");
    Belief& belief = predicted.front().belief;
    LapClock clock;
    double predictMs = 0.0;
    const Prediction prediction = view.predict(belief);
    clock.lap(predictMs);

    BatchSearch search(belief, prediction, view, {gate_, maxCandidates(), options_});
    const std::vector<PixelMeasurement> pixels = pixelsOf(search.problem(), choose(search));
    AssociationCounters& counters = search.counters;
    counters.updateMs = predictMs;
    counters.pairs = static_cast<long>(search.problem().rows.size());
    counters.rejected = counters.pairs - static_cast<long>(pixels.size());
    if (!pixels.empty())
    {
        LapClock updateClock;
        int faults = 0;
        belief = view.engine.update(std::move(belief), prediction, pixels, &faults);
        counters.faults += faults;
        updateClock.lap(counters.updateMs);
    }
    return {std::move(predicted), std::move(search.associations), counters};
}
}  // namespace monoslam
