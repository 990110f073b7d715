// SPDX-License-Identifier: BSD-3-Clause
#include "matchRest.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "ConditionalPrediction.h"
#include "bestCandidates.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
SearchRegion regionOf(const PredictedLandmark& row, const ClutterOptions& clutter)
{
    SearchRegion region;
    region.id = row.id;
    region.centre = row.h;
    region.S = row.S;
    region.gate = chi2Limit(2, clutter.p_search);
    region.maxCandidates = clutter.max_candidates;
    region.minScore = clutter.min_zncc;
    return region;
}

const Candidate& nearest(const std::vector<Candidate>& candidates, const SearchRegion& region)
{
    const Eigen::Matrix2d precision = region.S.inverse();
    const auto d2 = [&](const Candidate& candidate)
    { return (candidate.z - region.centre).dot(precision * (candidate.z - region.centre)); };
    return *std::min_element(candidates.begin(), candidates.end(),
                             [&](const Candidate& a, const Candidate& b) { return d2(a) < d2(b); });
}
}  // namespace

void matchRest(const MatchingFrame& frame, const ClutterOptions& clutter,
               std::vector<PixelMeasurement>& pixels)
{
    ThreadClock clock;
    std::optional<ConditionalPrediction> given;
    if (!pixels.empty()) given.emplace(frame.prediction, pixels);
    int left = frame.max_measured;
    for (const Eigen::Index index : frame.rows)
    {
        if (left <= 0) break;
        const PredictedLandmark& row = frame.prediction.rows[static_cast<std::size_t>(index)];
        SearchRegion region = regionOf(row, clutter);
        if (given && given->valid())
        {
            const ConditionalPrediction::Row conditional = given->row(index);
            region.centre = row.h + conditional.shift;
            region.S =
                conditional.HPHt + row.R + kLinearizationVariance_px2 * Eigen::Matrix2d::Identity();
        }
        if (!region.centre.allFinite() || !positiveDefinite(region.S)) continue;
        SearchResult result = frame.view.search(region);
        ++frame.counters.searches;
        frame.counters.pixelsCorrelated += result.pixels;
        if (result.status != SearchStatus::Done) continue;
        --left;
        Association& record = frame.associations[static_cast<std::size_t>(index)];
        record.h = region.centre;
        record.S = region.S;
        record.fate = Fate::NotFound;
        const auto found = bestCandidates(std::move(result.candidates), clutter.max_candidates);
        if (found.empty()) continue;
        const Candidate& chosen = nearest(found, region);
        record.fate = Fate::Matched;
        record.z = chosen.z;
        record.R = chosen.R;
        record.score = chosen.score;
        pixels.push_back({index, chosen.z, chosen.R});
    }
    frame.counters.searchMs += clock.lap_ms();
}
}  // namespace monoslam
