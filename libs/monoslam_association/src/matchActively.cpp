// SPDX-License-Identifier: BSD-3-Clause
#include "matchActively.h"

#include <algorithm>

#include "MatchingMixture.h"
#include "bestCandidates.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ConfigSection.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
/** Searches the ellipse of one Gaussian's prediction of a row; false if that was not possible. */
bool searchRow(const MatchingFrame& frame, const ClutterOptions& clutter,
               const MatchingTarget& target, std::vector<Candidate>& found)
{
    Association& record = frame.associations[static_cast<std::size_t>(target.row)];
    SearchRegion region;
    region.id = record.id;
    region.centre = record.h = target.centre;
    region.S = record.S = target.S;
    region.gate = target.gate;
    region.maxCandidates = clutter.max_candidates;
    region.minScore = clutter.min_zncc;
    SearchResult result = frame.view.search(region);
    ++frame.counters.searches;
    frame.counters.pixelsCorrelated += result.pixels;
    if (result.status != SearchStatus::Done) return false;
    found = bestCandidates(std::move(result.candidates), clutter.max_candidates);
    if (found.empty())
    {
        if (record.fate == Fate::NotSearched) record.fate = Fate::NotFound;
        return true;
    }
    record.fate = Fate::Rejected;
    record.z = found.front().z;
    record.R = found.front().R;
    record.score = found.front().score;
    return true;
}

/** Pixels of the heaviest Gaussian, noted as matches. */
std::vector<PixelMeasurement> answer(const MatchingMixture& mixture, const MatchingFrame& frame)
{
    std::vector<PixelMeasurement> pixels;
    for (const Eigen::Index row : frame.rows)
    {
        const auto& chosen = mixture.heaviest().chosen[static_cast<std::size_t>(row)];
        if (!chosen) continue;
        Association& record = frame.associations[static_cast<std::size_t>(row)];
        record.fate = Fate::Matched;
        record.z = chosen->z;
        record.R = chosen->R;
        record.score = chosen->score;
        pixels.push_back({row, chosen->z, chosen->R});
    }
    return pixels;
}
}  // namespace

MatchingOptions MatchingOptions::from(ConfigSection& section)
{
    MatchingOptions o;
    o.clutter = ClutterOptions::from(section);
    o.prune = section.get("prune", o.prune, {1e-12, 1.0});
    o.max_gaussians = section.get("max_gaussians", o.max_gaussians, {1.0, 1000.0});
    o.stop_bits = section.get("stop_bits", o.stop_bits, {0.0, 1e3});
    return o;
}

std::vector<PixelMeasurement> matchActively(std::unique_ptr<PixelGaussian> prior,
                                            const MatchingOptions& options,
                                            const MatchingFrame& frame)
{
    ThreadClock clock;
    MatchingMixture mixture(std::move(prior), frame.prediction, frame.rows,
                            {options, frame.view.imageArea_px2});
    for (int measured = 0; measured < frame.max_measured && mixture.heaviestIsOpen();)
    {
        const auto target = mixture.mostEfficient();
        frame.counters.selectMs += clock.lap_ms();
        if (!target) break;
        std::vector<Candidate> found;
        const bool searched = searchRow(frame, options.clutter, *target, found);
        frame.counters.searchMs += clock.lap_ms();
        if (searched)
            mixture.split(*target, found);
        else
            mixture.giveUp(target->row);
        measured += searched ? 1 : 0;
        ++frame.counters.nodes;
    }
    frame.counters.leaves += static_cast<long>(mixture.size());
    const auto pixels = answer(mixture, frame);
    frame.counters.selectMs += clock.lap_ms();
    return pixels;
}
}  // namespace monoslam
