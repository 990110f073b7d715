// SPDX-License-Identifier: BSD-3-Clause
// What the keeper remembers of its landmarks: how each fared in each belief, and how it looked.
#include <algorithm>

#include "MapKeeper.h"

namespace monoslam
{
namespace
{
void note(const std::vector<Association>& associations, long frame, TrackRecords& tracks)
{
    for (const Association& association : associations)
    {
        const auto it = tracks.find(association.id);
        if (it == tracks.end() || association.fate == Fate::NotSearched) continue;
        TrackRecord& track = it->second;
        ++track.searched;
        if (association.fate != Fate::NotFound) ++track.found;
        if (association.fate == Fate::Rejected) track.strikes.push_back(frame);
        if (association.fate != Fate::Matched) continue;
        ++track.matched;
        track.lastSeen = frame;
    }
}
}  // namespace

void MapKeeper::noteFates(const Mixture& mixture, const Correction& correction, long frame)
{
    if (!correction.parents.empty())
    {
        std::vector<TrackRecords> inherited;
        for (const std::size_t parent : correction.parents) inherited.push_back(tracks_.at(parent));
        tracks_ = std::move(inherited);
    }
    for (std::size_t b = 0; b < mixture.size(); ++b)
        note(correction.ofEveryBelief.empty() ? correction.associations
                                              : correction.ofEveryBelief[b],
             frame, tracks_.at(b));
    best_ = bestIndex(mixture);
    for (auto& [id, record] : records_)
    {
        const auto track = tracks_[best_].find(id);
        if (track != tracks_[best_].end()) static_cast<TrackRecord&>(record) = track->second;
    }
    const auto isMatch = [](const Association& a) { return a.fate == Fate::Matched; };
    matchedNow_ = static_cast<int>(
        std::count_if(correction.associations.begin(), correction.associations.end(), isMatch));
}

/** Takes landmarks out of one belief; what is in none any more is forgotten. */
void MapKeeper::remove(Mixture& mixture, std::size_t belief, const std::vector<LandmarkId>& ids)
{
    mixture[belief].belief = removeLandmarks(std::move(mixture[belief].belief), ids);
    for (const LandmarkId id : ids)
    {
        tracks_[belief].erase(id);
        const bool held = std::any_of(tracks_.begin(), tracks_.end(),
                                      [id](const auto& tracks) { return tracks.count(id) > 0; });
        if (!held) removed_ += static_cast<int>(records_.erase(id));
    }
}

/** Remembers a landmark that has been added to the beliefs. */
void MapKeeper::enter(LandmarkId id, LandmarkRecord record, const Mixture& mixture)
{
    tracks_.resize(mixture.size());
    const TrackRecord& track = record;
    for (std::size_t b = 0; b < mixture.size(); ++b)
        if (mixture[b].belief.find(id) >= 0) tracks_[b][id] = track;
    records_[id] = std::move(record);
}

void MapKeeper::keepOnly(const Belief& belief)
{
    corners_.clear();
    TrackRecords tracks = best_ < tracks_.size() ? std::move(tracks_[best_]) : TrackRecords();
    tracks_.clear();
    for (auto it = records_.begin(); it != records_.end();)
    {
        const bool gone = belief.find(it->first) < 0;
        if (gone) tracks.erase(it->first);
        it = gone ? records_.erase(it) : std::next(it);
        removed_ += gone ? 1 : 0;
    }
    tracks_.push_back(std::move(tracks));
    best_ = 0;
}

void MapKeeper::takeOver(LandmarkRecords records)
{
    corners_.clear();
    records_ = std::move(records);
    tracks_.assign(1, {});
    for (const auto& [id, record] : records_) tracks_.front()[id] = record;
    best_ = 0;
}
}  // namespace monoslam
