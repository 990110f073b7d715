// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/RecordedFrame.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

#include "bestCandidates.h"

namespace monoslam
{
namespace
{
/** Of a number's size: another compiler's rounding passes, another belief or camera does not. */
constexpr double kTolerance = 1e-6;

SearchResult searchRecorded(const RecordedLandmark& landmark, const SearchRegion& region,
                            double minScore)
{
    SearchResult result;
    result.status = landmark.status;
    if (landmark.status != SearchStatus::Done) return result;
    const double area_px2 = std::acos(-1.0) * region.gate * std::sqrt(region.S.determinant());
    result.pixels = std::lround(area_px2);
    const Eigen::Matrix2d precision = region.S.inverse();
    for (const Candidate& candidate : landmark.candidates)
    {
        const Eigen::Vector2d nu = candidate.z - region.centre;
        if (static_cast<int>(result.candidates.size()) >= region.maxCandidates) break;
        if (candidate.score < minScore || !(nu.dot(precision * nu) < region.gate)) continue;
        result.candidates.push_back(candidate);
    }
    return result;
}

bool known(const std::vector<Candidate>& candidates, const Candidate& candidate)
{
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](const Candidate& other) { return other.z == candidate.z; });
}

/** Adds what is new of a search's answer. */
void add(RecordedLandmark& landmark, const SearchResult& found, const RecordLimits& limits)
{
    if (found.status == SearchStatus::Done) landmark.status = SearchStatus::Done;
    for (const Candidate& candidate : found.candidates)
        if (!known(landmark.candidates, candidate)) landmark.candidates.push_back(candidate);
    landmark.candidates = bestCandidates(std::move(landmark.candidates), limits.maxCandidates);
}

/** Searches one landmark for one belief and adds what is new. */
void add(RecordedLandmark& landmark, const PredictedLandmark& row, const RecordLimits& limits,
         const FrameView& view)
{
    if (!row.h.allFinite() || !positiveDefinite(row.S)) return;
    SearchRegion region;
    region.id = row.id;
    region.centre = row.h;
    region.S = row.S;
    region.gate = limits.gate;
    region.maxCandidates = limits.maxCandidates;
    region.minScore = limits.minScore;
    add(landmark, view.search(region), limits);
}

void compare(LandmarkId id, const char* quantity, const Eigen::MatrixXd& recorded,
             const Eigen::MatrixXd& predicted)
{
    const double difference = (recorded - predicted).cwiseAbs().maxCoeff();
    if (difference <= kTolerance * (1.0 + predicted.cwiseAbs().maxCoeff())) return;
    throw std::invalid_argument("landmark " + std::to_string(id) + ": " + quantity +
                                " is not what belief and camera predict: it differs by " +
                                std::to_string(difference));
}
}  // namespace

FrameView RecordedFrame::view() const
{
    std::map<LandmarkId, const RecordedLandmark*> byId;
    for (const RecordedLandmark& landmark : landmarks) byId[landmark.id] = &landmark;
    FrameView view;
    view.predict = [this](const Belief& belief)
    { return predictMeasurements(belief, camera, visibility); };
    view.linearize = [this](const Eigen::VectorXd& x, const LandmarkSlot& slot)
    { return linearizeLandmark(x, slot, camera, visibility); };
    view.search = [this, byId = std::move(byId)](const SearchRegion& region)
    {
        const auto entry = byId.find(region.id);
        if (entry != byId.end())
            return searchRecorded(*entry->second, region, region.minScore.value_or(minScore));
        SearchResult nothing;
        nothing.status = SearchStatus::Unpredictable;
        return nothing;
    };
    const CameraParameters& size = camera.parameters();
    view.imageArea_px2 = 1.0 * size.width_px * size.height_px;
    return view;
}

void RecordedFrame::check() const
{
    for (const WeightedBelief& weighted : mixture)
    {
        try
        {
            weighted.belief.checkInvariant();
        }
        catch (const std::logic_error& error)
        {
            throw std::invalid_argument(error.what());
        }
    }
    if (mixture.empty()) throw std::invalid_argument("no belief");
    std::map<LandmarkId, PredictedLandmark> byId;
    for (PredictedLandmark& row : predictMeasurements(best(mixture), camera, visibility).rows)
        byId[row.id] = row;
    for (const RecordedLandmark& landmark : landmarks)
    {
        const auto row = byId.find(landmark.id);
        if (landmark.predicted.has_value() != (row != byId.end()))
            throw std::invalid_argument(
                "landmark " + std::to_string(landmark.id) +
                (row == byId.end() ? ": is recorded as visible and is not, by belief and camera"
                                   : ": is recorded as not visible and is, by belief and camera"));
        if (!landmark.predicted) continue;
        const PredictedLandmark& there = *landmark.predicted;
        compare(landmark.id, "h", there.h, row->second.h);
        compare(landmark.id, "H_v", there.H_v, row->second.H_v);
        compare(landmark.id, "H_y", there.H_y.leftCols(there.size),
                row->second.H_y.leftCols(row->second.size));
        compare(landmark.id, "S", there.S, row->second.S);
    }
}

RecordedFrame recordFrame(RecordedFrame frame, const FrameView& view)
{
    frame.landmarks.clear();
    std::map<LandmarkId, RecordedLandmark> byId;
    const std::size_t heaviest = bestIndex(frame.mixture);
    for (std::size_t i = 0; i < frame.mixture.size(); ++i)
        for (PredictedLandmark& row : view.predict(frame.mixture[i].belief).rows)
        {
            const auto [at, fresh] = byId.try_emplace(row.id);
            at->second.id = row.id;
            if (fresh) at->second.status = SearchStatus::Unpredictable;
            add(at->second, row, frame.limits, view);
            if (i == heaviest) at->second.predicted = row;
        }
    for (auto& [id, landmark] : byId) frame.landmarks.push_back(std::move(landmark));
    return frame;
}

RecordedFrame withAnswers(RecordedFrame frame, const FrameView& view, const Associator& strategy,
                          std::mt19937 rng)
{
    std::map<LandmarkId, RecordedLandmark*> byId;
    for (RecordedLandmark& landmark : frame.landmarks) byId[landmark.id] = &landmark;
    std::mutex mutex;
    FrameView listening = view;
    listening.search = [&](const SearchRegion& region)
    {
        const SearchResult answer = view.search(region);
        const std::lock_guard<std::mutex> lock(mutex);
        const auto landmark = byId.find(region.id);
        if (landmark != byId.end()) add(*landmark->second, answer, frame.limits);
        return answer;
    };
    static_cast<void>(strategy.correct(frame.mixture, listening, rng));
    return frame;
}
}  // namespace monoslam
