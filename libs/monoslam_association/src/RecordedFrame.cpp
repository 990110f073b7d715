// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/RecordedFrame.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "bestCandidates.h"

namespace monoslam
{
namespace
{
bool isInside(const SearchRegion& region, const Candidate& candidate)
{
    const Eigen::Vector2d nu = candidate.z - region.centre;
    return nu.dot(region.S.inverse() * nu) < region.gate;
}

SearchResult searchRecorded(const RecordedLandmark& landmark, const SearchRegion& region,
                            double minScore)
{
    SearchResult result;
    result.status = landmark.status;
    if (landmark.status != SearchStatus::Done) return result;
    const double area_px2 = std::acos(-1.0) * region.gate * std::sqrt(region.S.determinant());
    result.pixels = std::lround(area_px2);
    for (const Candidate& candidate : landmark.candidates)
    {
        if (static_cast<int>(result.candidates.size()) >= region.maxCandidates) break;
        if (candidate.score < minScore || !isInside(region, candidate)) continue;
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

/** Removes what would be preferred to a region's answer and is not in it. */
void removeUnseen(RecordedLandmark& landmark, const SearchRegion& region,
                  const SearchResult& answer, double minScore)
{
    if (answer.status != SearchStatus::Done) return;
    const bool full = static_cast<int>(answer.candidates.size()) >= region.maxCandidates;
    const double least = full ? answer.candidates.back().score : region.minScore.value_or(minScore);
    const auto unseen = [&](const Candidate& candidate)
    {
        return candidate.score >= least && isInside(region, candidate) &&
               !known(answer.candidates, candidate);
    };
    auto& candidates = landmark.candidates;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), unseen),
                     candidates.end());
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
    std::vector<std::pair<SearchRegion, SearchResult>> answers;
    std::mutex mutex;
    FrameView listening = view;
    listening.search = [&](const SearchRegion& region)
    {
        SearchResult answer = view.search(region);
        const std::lock_guard<std::mutex> lock(mutex);
        answers.emplace_back(region, answer);
        return answer;
    };
    static_cast<void>(strategy.correct(frame.mixture, listening, rng));

    std::map<LandmarkId, RecordedLandmark*> byId;
    for (RecordedLandmark& landmark : frame.landmarks) byId[landmark.id] = &landmark;
    for (const auto& [region, answer] : answers)
        if (byId.count(region.id) > 0)
            removeUnseen(*byId[region.id], region, answer, frame.minScore);
    for (const auto& [region, answer] : answers)  // what another region removed comes back
        if (byId.count(region.id) > 0) add(*byId[region.id], answer, frame.limits);
    return frame;
}
}  // namespace monoslam
