// SPDX-License-Identifier: BSD-3-Clause
#include "BatchSearch.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "ConditionalPrediction.h"
#include "bestCandidates.h"
#include "relinearize.h"

namespace monoslam
{
BatchSearch::BatchSearch(Prediction prediction, const FrameView& view, const Settings& settings)
    : prediction_(std::move(prediction)), view_(view), settings_(settings)
{
    problem_.prediction = &prediction_;
    problem_.imageArea_px2 = view.imageArea_px2;
    listRows();
}

void BatchSearch::listRows()
{
    for (Eigen::Index row = 0; row < prediction_.count(); ++row)
    {
        const PredictedLandmark& landmark = at(row);
        Association record;
        record.id = landmark.id;
        record.h = landmark.h;
        record.S = landmark.S;
        record.z = landmark.h;
        record.R = landmark.R;
        associations.push_back(record);
        if (landmark.h.allFinite() && positiveDefinite(landmark.S)) untried_.push_back(row);
    }
    std::sort(untried_.begin(), untried_.end(),
              [this](Eigen::Index a, Eigen::Index b) { return at(a).id < at(b).id; });
}

const PredictedLandmark& BatchSearch::at(Eigen::Index row) const
{
    return prediction_.rows[static_cast<std::size_t>(row)];
}

SearchRegion BatchSearch::ownRegion(Eigen::Index row) const
{
    SearchRegion region;
    region.id = at(row).id;
    region.centre = at(row).h;
    region.S = at(row).S;
    region.gate = settings_.gate;
    region.minScore = settings_.minScore;
    return region;
}

SearchRegion BatchSearch::regionGiven(const ConditionalPrediction& accepted, Eigen::Index row) const
{
    const ConditionalPrediction::Row given = accepted.row(row);
    SearchRegion region = ownRegion(row);
    region.centre = at(row).h + given.shift;
    region.S = given.HPHt + at(row).R + kLinearizationVariance_px2 * Eigen::Matrix2d::Identity();
    return region;
}

void BatchSearch::moveTo(Prediction prediction)
{
    const std::map<LandmarkId, Eigen::Index> rowOf = rowsById(prediction);
    AssociationProblem moved;
    moved.imageArea_px2 = problem_.imageArea_px2;
    for (std::size_t i = 0; i < problem_.rows.size(); ++i)
    {
        const auto row = rowOf.find(at(problem_.rows[i]).id);
        if (row == rowOf.end()) continue;
        moved.rows.push_back(row->second);
        moved.candidates.push_back(std::move(problem_.candidates[i]));
        moved.regions.push_back(problem_.regions[i]);
    }
    std::map<LandmarkId, Association> before;
    for (const Association& record : associations) before[record.id] = record;
    std::set<LandmarkId> tried;
    for (const auto& record : associations) tried.insert(record.id);
    for (const Eigen::Index row : untried_) tried.erase(at(row).id);

    prediction_ = std::move(prediction);
    problem_ = std::move(moved);
    problem_.prediction = &prediction_;
    associations.clear();
    untried_.clear();
    listRows();
    for (Association& record : associations)
        if (tried.count(record.id) > 0) record = before.at(record.id);
    untried_.erase(std::remove_if(untried_.begin(), untried_.end(),
                                  [&](Eigen::Index row) { return tried.count(at(row).id) > 0; }),
                   untried_.end());
}

bool BatchSearch::search(Eigen::Index row, SearchRegion region, int maxCandidates)
{
    region.maxCandidates = maxCandidates;
    if (!region.centre.allFinite() || !positiveDefinite(region.S)) return false;
    SearchResult result = view_.search(region);
    ++counters.searches;
    counters.pixelsCorrelated += result.pixels;
    Association& record = associations[static_cast<std::size_t>(row)];
    record.h = region.centre;
    record.S = region.S;
    if (result.status != SearchStatus::Done) return false;

    record.fate = Fate::NotFound;
    std::vector<Candidate> found = bestCandidates(std::move(result.candidates), maxCandidates);
    if (found.empty()) return true;
    record.fate = Fate::Rejected;
    problem_.rows.push_back(row);
    problem_.candidates.push_back(std::move(found));
    problem_.regions.push_back(region);
    return true;
}

void BatchSearch::searchFirstStage()
{
    const int wanted = std::min(settings_.options.first_stage, settings_.options.max_measured);
    const double distance_px = settings_.options.first_stage_distance_px;
    std::vector<Eigen::Index> left;
    for (const Eigen::Index row : untried_)
    {
        const auto near = [&](const Eigen::Vector2d& h)
        { return (h - at(row).h).norm() < distance_px; };
        if (static_cast<int>(searched_.size()) >= wanted ||
            std::any_of(searched_.begin(), searched_.end(), near))
            left.push_back(row);
        else if (search(row, ownRegion(row), settings_.firstStageCandidates))
            searched_.push_back(at(row).h);
    }
    untried_ = std::move(left);
}

std::vector<double> BatchSearch::spreads() const
{
    std::vector<double> distances(untried_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < untried_.size(); ++i)
        for (const Eigen::Vector2d& h : searched_)
            distances[i] = std::min(distances[i], (h - at(untried_[i]).h).norm());
    return distances;
}

void BatchSearch::pickSpread(const std::function<SearchRegion(Eigen::Index)>& regionOf)
{
    std::vector<double> distances = spreads();
    while (!untried_.empty() && static_cast<int>(searched_.size()) < settings_.options.max_measured)
    {
        const auto farthest = std::max_element(distances.begin(), distances.end());
        const auto index = farthest - distances.begin();
        const Eigen::Index row = untried_[static_cast<std::size_t>(index)];
        untried_.erase(untried_.begin() + index);
        distances.erase(farthest);
        if (!search(row, regionOf(row), settings_.maxCandidates)) continue;
        searched_.push_back(at(row).h);
        for (std::size_t i = 0; i < untried_.size(); ++i)
            distances[i] = std::min(distances[i], (at(row).h - at(untried_[i]).h).norm());
    }
}

/** The first stage's decision among several candidates is final but for a rejection. */
void BatchSearch::keepChosen(std::vector<int>& accepted)
{
    const auto most = static_cast<std::size_t>(settings_.maxCandidates);
    for (std::size_t i = 0; i < accepted.size(); ++i)
    {
        std::vector<Candidate>& candidates = problem_.candidates[i];
        if (candidates.size() <= most) continue;
        if (accepted[i] >= 0)
            std::rotate(candidates.begin(), candidates.begin() + accepted[i],
                        candidates.begin() + accepted[i] + 1);
        candidates.resize(most);
        accepted[i] = std::min(accepted[i], 0);
    }
}

/** A wide gate may hold several peaks, and what the decision rejected may have been wrong ones; the
 *  shrunken gate holds the right one. */
void BatchSearch::searchRejectedAgain(const std::vector<int>& accepted,
                                      const ConditionalPrediction& given)
{
    if (std::find(accepted.begin(), accepted.end(), -1) == accepted.end()) return;
    AssociationProblem before;
    std::swap(before.rows, problem_.rows);
    std::swap(before.candidates, problem_.candidates);
    std::swap(before.regions, problem_.regions);
    for (std::size_t i = 0; i < before.rows.size(); ++i)
    {
        const Eigen::Index row = before.rows[i];
        if (accepted[i] < 0)
        {
            Association& record = associations[static_cast<std::size_t>(row)];
            const Association first = record;
            if (search(row, regionGiven(given, row), settings_.maxCandidates)) continue;
            record = first;
        }
        problem_.rows.push_back(row);
        problem_.candidates.push_back(std::move(before.candidates[i]));
        problem_.regions.push_back(before.regions[i]);
    }
}

bool BatchSearch::searchRest(std::vector<int>& accepted)
{
    const long before = counters.searches;
    keepChosen(accepted);
    const std::vector<PixelMeasurement> pixels = pixelsOf(problem_, accepted);
    std::optional<ConditionalPrediction> given;
    if (pixels.size() >= kPoseFixingPairs) given.emplace(prediction_, pixels);
    if (given && given->valid())
    {
        searchRejectedAgain(accepted, *given);
        pickSpread([&](Eigen::Index row) { return regionGiven(*given, row); });
    }
    else
        pickSpread([this](Eigen::Index row) { return ownRegion(row); });
    return counters.searches > before;
}
}  // namespace monoslam
