// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <ctime>
#include <map>
#include <stdexcept>

#include "BatchSearch.h"
#include "ConditionalPrediction.h"
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
/** Movement in the image, from where the projection was linearised to the posterior, below which
 *  its bend does not matter [px]: a turn by c pixels bends it by about c^2 / 1000. */
constexpr double kLinearEnough_px = 5.0;

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

/** Prediction of the prior linearised at x: its h is h(x) + H (x_prior - x), so that z - h is the
 *  innovation of an iterated EKF. */
Prediction predictAt(const FrameView& view, Belief& prior, Eigen::VectorXd x)
{
    prior.x.swap(x);  // for a moment: a copy would copy the covariance too
    Prediction prediction = view.predict(prior);
    prior.x.swap(x);
    const Eigen::VectorXd back = prior.x - x;
    for (PredictedLandmark& row : prediction.rows)
        row.h += row.H_v * back.head<camera_state::kSize>() +
                 row.H_y.leftCols(row.size) * back.segment(row.offset, row.size);
    return prediction;
}

/** The same pixels as measurements of another prediction's rows, landmark by landmark. */
std::vector<PixelMeasurement> onRowsOf(const Prediction& to, const Prediction& from,
                                       const std::vector<PixelMeasurement>& pixels)
{
    std::map<LandmarkId, Eigen::Index> rowOf;
    for (std::size_t row = 0; row < to.rows.size(); ++row)
        rowOf[to.rows[row].id] = static_cast<Eigen::Index>(row);
    std::vector<PixelMeasurement> moved;
    for (PixelMeasurement pixel : pixels)
    {
        const auto row = rowOf.find(from.rows[static_cast<std::size_t>(pixel.row)].id);
        if (row == rowOf.end()) continue;
        pixel.row = row->second;
        moved.push_back(pixel);
    }
    return moved;
}

/** How far the measured landmarks move in the image between two states [px], the farthest. */
double largestShift_px(const Prediction& prediction, const std::vector<PixelMeasurement>& pixels,
                       const Eigen::VectorXd& d)
{
    double largest = 0.0;
    for (const PixelMeasurement& pixel : pixels)
    {
        const auto& row = prediction.rows[static_cast<std::size_t>(pixel.row)];
        const Eigen::Vector2d shift =
            row.H_v * d.head<camera_state::kSize>() +
            row.H_y.leftCols(row.size) * d.segment(row.offset, row.size);
        largest = std::max(largest, shift.norm());
    }
    return largest;
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

std::vector<int> BatchAssociator::choose(BatchSearch& search, Belief& prior,
                                        const FrameView& view) const
{
    LapClock clock;
    AssociationCounters& counters = search.counters;
    search.searchFirstStage();
    clock.lap(counters.searchMs);
    const std::vector<int> first = decide(search.problem(), counters);
    clock.lap(counters.selectMs);
    const auto known = pixelsOf(search.problem(), first);
    std::vector<int> accepted = first;
    if (options_.max_iterations > 1 && known.size() >= kPoseFixingPairs)
    {
        search.linearizedAt = ekfUpdateMean(prior, search.prediction(), known);
        search.moveTo(predictAt(view, prior, search.linearizedAt));
        clock.lap(counters.updateMs);
        accepted = decide(search.problem(), counters);
        clock.lap(counters.selectMs);
    }
    search.searchRest(accepted);
    clock.lap(counters.searchMs);

    const AssociationProblem& problem = search.problem();
    std::vector<int> chosen =
        problem.rows.size() == accepted.size() ? accepted : decide(problem, counters);
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

Belief BatchAssociator::update(Belief& prior, BatchSearch& search,
                               const std::vector<PixelMeasurement>& pixels,
                               const FrameView& view) const
{
    int faults = 0;
    Belief posterior = view.engine.update(prior, search.prediction(), pixels, &faults);
    Eigen::VectorXd linearizedAt = search.linearizedAt.size() > 0 ? search.linearizedAt : prior.x;
    for (int iteration = 2; iteration < options_.max_iterations; ++iteration)
    {
        const Eigen::VectorXd step = posterior.x - linearizedAt;
        if (largestShift_px(search.prediction(), pixels, step) < kLinearEnough_px) break;
        const Prediction again = predictAt(view, prior, posterior.x);
        const auto moved = onRowsOf(again, search.prediction(), pixels);
        if (moved.size() < pixels.size()) break;  // a landmark left the image: keep what we have
        linearizedAt = posterior.x;
        posterior = view.engine.update(prior, again, moved, &faults);
    }
    search.counters.faults += faults;
    return posterior;
}

Correction BatchAssociator::correct(Mixture predicted, const FrameView& view,
                                    std::mt19937& /*rng*/) const
{
    if (predicted.size() != 1)
        throw std::logic_error("BatchAssociator: the mixture must hold exactly one belief");
    Belief& belief = predicted.front().belief;
    LapClock clock;
    double predictMs = 0.0;
    BatchSearch search(view.predict(belief), view, {gate_, maxCandidates(), options_});
    clock.lap(predictMs);

    const std::vector<int> chosen = choose(search, belief, view);
    const std::vector<PixelMeasurement> pixels = pixelsOf(search.problem(), chosen);
    AssociationCounters& counters = search.counters;
    counters.updateMs += predictMs;
    counters.pairs = static_cast<long>(search.problem().rows.size());
    counters.rejected = counters.pairs - static_cast<long>(pixels.size());
    if (!pixels.empty())
    {
        LapClock updateClock;
        belief = update(belief, search, pixels, view);
        updateClock.lap(counters.updateMs);
    }
    return {std::move(predicted), std::move(search.associations), counters};
}
}  // namespace monoslam
