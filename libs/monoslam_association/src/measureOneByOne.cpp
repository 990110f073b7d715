// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/measureOneByOne.h"

#include <Eigen/LU>
#include <algorithm>

#include "bestCandidates.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
constexpr double kTaken_px = 3.0;

class Loop
{
   public:
    Loop(Belief predicted, const FrameView& view, const SequentialSettings& settings,
         SequentialRule& rule)
        : view_(view), settings_(settings), rule_(rule), update_(std::move(predicted), view)
    {
        for (const OpenLandmark& landmark : update_.landmarks())
        {
            Association& record = outcome_.associations.emplace_back();
            record.id = landmark.slot.id;
            record.h = record.z = landmark.row.h;
            record.S = landmark.row.S;
            record.R = landmark.row.R;
        }
        outcome_.counters.updateMs += clock_.lap_ms();
    }

    SequentialOutcome run() &&
    {
        for (int measured = 0; measured < settings_.max_measured;)
        {
            const auto next = rule_.next(update_);
            outcome_.counters.selectMs += clock_.lap_ms();
            if (!next) break;
            measured += measure(*next) ? 1 : 0;
        }
        outcome_.belief = std::move(update_).finish();
        outcome_.counters.updateMs += clock_.lap_ms();
        return std::move(outcome_);
    }

   private:
    [[nodiscard]] SearchRegion regionOf(const PredictedLandmark& row) const
    {
        SearchRegion region;
        region.id = row.id;
        region.centre = row.h;
        region.S = row.S;
        region.gate = settings_.gate;
        region.maxCandidates = settings_.maxCandidates;
        region.minScore = settings_.minScore;
        return region;
    }

    /** True if the landmark was searched; it is closed in any case. */
    bool measure(std::size_t i)
    {
        const bool visible = update_.linearize(i);
        outcome_.counters.updateMs += clock_.lap_ms();
        const PredictedLandmark& row = update_.landmarks()[i].row;
        SearchResult found;
        found.status = SearchStatus::Unpredictable;
        if (visible)
        {
            found = view_.search(regionOf(row));
            ++outcome_.counters.searches;
            outcome_.counters.pixelsCorrelated += found.pixels;
        }
        outcome_.counters.searchMs += clock_.lap_ms();
        if (found.status == SearchStatus::Done)
            associate(i, bestCandidates(std::move(found.candidates), settings_.maxCandidates));
        update_.close(i);
        return found.status == SearchStatus::Done;
    }

    void associate(std::size_t i, const std::vector<Candidate>& candidates)
    {
        const PredictedLandmark row = update_.landmarks()[i].row;
        Association& record = outcome_.associations[i];
        record.h = row.h;
        record.S = row.S;
        const std::vector<Candidate> free = withoutTaken(candidates);
        const int choice = rule_.accept(row, free);
        outcome_.counters.selectMs += clock_.lap_ms();
        record.fate = candidates.empty() ? Fate::NotFound : Fate::Rejected;
        if (candidates.empty()) return;
        const Candidate& chosen =
            choice < 0 ? candidates.front() : free[static_cast<std::size_t>(choice)];
        keep(record, row, chosen);
        if (choice >= 0)
        {
            const bool corrected = update_.correct(i, chosen.z, chosen.R);
            record.fate = corrected ? Fate::Matched : Fate::Rejected;
            outcome_.counters.faults += corrected ? 0 : 1;
            if (corrected) taken_.push_back(chosen.z);
        }
        ++outcome_.counters.pairs;
        outcome_.counters.rejected += record.fate == Fate::Rejected ? 1 : 0;
        outcome_.counters.updateMs += clock_.lap_ms();
    }

    static void keep(Association& record, const PredictedLandmark& row, const Candidate& chosen)
    {
        record.z = chosen.z;
        record.R = chosen.R;
        record.score = chosen.score;
        const Eigen::Matrix2d S = row.S - row.R + chosen.R;
        const Eigen::Vector2d nu = chosen.z - row.h;
        record.nis = nu.dot(S.inverse() * nu);
    }

    [[nodiscard]] std::vector<Candidate> withoutTaken(std::vector<Candidate> candidates) const
    {
        const auto taken = [this](const Candidate& candidate)
        {
            return std::any_of(taken_.begin(), taken_.end(),
                               [&](const Eigen::Vector2d& z)
                               { return (z - candidate.z).norm() < kTaken_px; });
        };
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(), taken),
                         candidates.end());
        return candidates;
    }

    const FrameView& view_;
    const SequentialSettings& settings_;
    SequentialRule& rule_;
    ThreadClock clock_;
    SequentialUpdate update_;
    SequentialOutcome outcome_;
    std::vector<Eigen::Vector2d> taken_;
};
}  // namespace

SequentialOutcome measureOneByOne(Belief predicted, const FrameView& view,
                                  const SequentialSettings& settings, SequentialRule& rule)
{
    return Loop(std::move(predicted), view, settings, rule).run();
}
}  // namespace monoslam
