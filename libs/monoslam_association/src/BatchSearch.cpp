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
    region.maxCandidates = settings_.maxCandidates;
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

bool BatchSearch::search(Eigen::Index row, const SearchRegion& region)
{
    if (!region.centre.allFinite() || !positiveDefinite(region.S)) return false;
    Association& record = associations[static_cast<std::size_t>(row)];
    record.h = region.centre;
    record.S = region.S;
    SearchResult result = view_.search(region);
    ++counters.searches;
    counters.pixelsCorrelated += result.pixels;
    if (result.status != SearchStatus::Done) return false;

    searched_.push_back(at(row).h);
    record.fate = Fate::NotFound;
    std::vector<Candidate> found =
        bestCandidates(std::move(result.candidates), settings_.maxCandidates);
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
        else
            search(row, ownRegion(row));
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
        if (!search(row, regionOf(row))) continue;
        for (std::size_t i = 0; i < untried_.size(); ++i)
            distances[i] = std::min(distances[i], (at(row).h - at(untried_[i]).h).norm());
    }
}

void BatchSearch::searchRest(const std::vector<int>& accepted)
{
    const std::vector<PixelMeasurement> pixels = pixelsOf(problem_, accepted);
    if (pixels.size() >= kPoseFixingPairs)
    {
        const ConditionalPrediction given(prediction_, pixels);
        if (given.valid())
            return pickSpread([&](Eigen::Index row) { return regionGiven(given, row); });
    }
    pickSpread([this](Eigen::Index row) { return ownRegion(row); });
}
}  // namespace monoslam
