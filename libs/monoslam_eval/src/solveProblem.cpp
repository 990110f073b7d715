// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/solveProblem.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
/** Joint D2 of the accepted pixels by the prior's prediction, infinite if S is singular. */
double jointD2(const RecordedFrame& frame, const std::vector<Association>& associations)
{
    const Prediction prediction =
        predictMeasurements(best(frame.mixture), frame.camera, frame.visibility);
    std::map<LandmarkId, Eigen::Index> rowOf;
    for (Eigen::Index row = 0; row < prediction.count(); ++row)
        rowOf[prediction.rows[static_cast<std::size_t>(row)].id] = row;
    IncrementalD2 stack(prediction.HPHt, prediction.count());
    for (const Association& a : associations)
    {
        const auto row = rowOf.find(a.id);
        if (a.fate != Fate::Matched || row == rowOf.end()) continue;
        const Eigen::Vector2d nu = a.z - prediction.rows[static_cast<std::size_t>(row->second)].h;
        if (!stack.push({row->second, nu, a.R})) return std::numeric_limits<double>::infinity();
    }
    return stack.d2();
}

/** Index of the accepted pixel among the candidates. */
int indexOf(const RecordedLandmark& landmark, const Eigen::Vector2d& z)
{
    for (std::size_t c = 0; c < landmark.candidates.size(); ++c)
        if (landmark.candidates[c].z == z) return static_cast<int>(c);
    throw std::logic_error("landmark " + std::to_string(landmark.id) +
                           ": accepted a pixel that is no candidate");
}

void judge(const RecordedFrame& frame, Solution& solution)
{
    std::map<LandmarkId, const RecordedLandmark*> byId;
    solution.truthKnown = true;
    for (const RecordedLandmark& landmark : frame.landmarks)
    {
        byId[landmark.id] = &landmark;
        solution.truthKnown = solution.truthKnown && landmark.truth;
        solution.present += landmark.truth.value_or(-1) >= 0 ? 1 : 0;
    }
    for (const Association& a : solution.correction.associations)
    {
        solution.rejected += a.fate == Fate::Rejected ? 1 : 0;
        if (a.fate != Fate::Matched) continue;
        ++solution.accepted;
        const RecordedLandmark& landmark = *byId.at(a.id);
        solution.right += indexOf(landmark, a.z) == landmark.truth.value_or(-1) ? 1 : 0;
    }
    if (!solution.truthKnown) solution.right = solution.present = 0;
}
}  // namespace

Solution solveProblem(const Associator& associator, const RecordedFrame& frame, unsigned seed)
{
    Mixture mixture = frame.mixture;
    if (!associator.traits().hypothesesBetweenFrames) mixture = {{best(frame.mixture), 0.0}};
    const FrameView view = frame.view();
    std::mt19937 rng(seed);
    Solution solution;
    ThreadClock clock;
    solution.correction = associator.correct(std::move(mixture), view, rng);
    const AssociationCounters& counters = solution.correction.counters;
    solution.total_ms = clock.lap_ms() + counters.otherThreadsMs;
    solution.associate_ms = counters.selectMs;
    solution.d2 = jointD2(frame, solution.correction.associations);
    judge(frame, solution);
    return solution;
}
}  // namespace monoslam
