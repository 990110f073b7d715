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
/** Bend of the projection that one more iteration would remove [px]. */
constexpr double kLinearEnough_px = 0.05;

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
Prediction predictAt(const FrameView& view, const Belief& prior, const Eigen::VectorXd& x)
{
    Belief moved = prior;
    moved.x = x;
    Prediction prediction = view.predict(moved);
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

/** How far, at the posterior, the pixel that the first linearisation expects is from the true
 *  projection [px], worst landmark. */
double largestBend_px(const Prediction& first, const std::vector<PixelMeasurement>& pixels,
                      const Prediction& again, const std::vector<PixelMeasurement>& moved,
                      const Belief& prior, const Belief& posterior)
{
    const Eigen::VectorXd d = posterior.x - prior.x;
    const auto expected = [&d](const PredictedLandmark& row)
    {
        return Eigen::Vector2d(row.h + row.H_v * d.head<camera_state::kSize>() +
                               row.H_y.leftCols(row.size) * d.segment(row.offset, row.size));
    };
    double largest = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
        const auto& before = first.rows[static_cast<std::size_t>(pixels[i].row)];
        const auto& after = again.rows[static_cast<std::size_t>(moved[i].row)];
        largest = std::max(largest, (expected(before) - expected(after)).norm());
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

std::vector<int> BatchAssociator::choose(BatchSearch& search, const Belief& prior,
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
        search.moveTo(predictAt(view, prior, ekfUpdateMean(prior, search.prediction(), known)));
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

Belief BatchAssociator::update(const Belief& prior, const Prediction& prediction,
                               const std::vector<PixelMeasurement>& pixels, const FrameView& view,
                               AssociationCounters& counters) const
{
    int faults = 0;
    Belief posterior = view.engine.update(prior, prediction, pixels, &faults);
    for (int iteration = 2; iteration < options_.max_iterations; ++iteration)
    {
        const Prediction again = predictAt(view, prior, posterior.x);
        const auto moved = onRowsOf(again, prediction, pixels);
        if (moved.size() < pixels.size()) break;  // a landmark left the image: keep what we have
        if (largestBend_px(prediction, pixels, again, moved, prior, posterior) < kLinearEnough_px)
            break;
        posterior = view.engine.update(prior, again, moved, &faults);
    }
    counters.faults += faults;
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
        belief = update(belief, search.prediction(), pixels, view, counters);
        updateClock.lap(counters.updateMs);
    }
    return {std::move(predicted), std::move(search.associations), counters};
}
}  // namespace monoslam
