// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_association/SequentialUpdate.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** What a strategy that measures one landmark after the other has to decide. */
class MONOSLAM_ASSOCIATION_EXPORT SequentialRule
{
   public:
    virtual ~SequentialRule() = default;
    /** Index in landmarks() of the open landmark that is measured next; nothing: the frame is done. */
    [[nodiscard]] virtual std::optional<std::size_t> next(const SequentialUpdate& update) = 0;
    /** The candidate to correct with, or -1; candidates may be empty, best score first. */
    [[nodiscard]] virtual int accept(const PredictedLandmark& landmark,
                                     const std::vector<Candidate>& candidates) = 0;
};

struct SequentialSettings
{
    double gate = 5.9915;
    int maxCandidates = 1;
    int max_measured = 60;
    std::optional<double> minScore;
};

struct SequentialOutcome
{
    Belief belief;
    std::vector<Association> associations;
    AssociationCounters counters;
};

/** Until the rule has enough: choose a landmark, linearise it at the current mean, search its
 *  ellipse, choose a candidate, correct at once. Candidates within 3 px of a pixel that is already
 *  taken are no candidates. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT SequentialOutcome
measureOneByOne(Belief predicted, const FrameView& view, const SequentialSettings& settings,
                SequentialRule& rule);
}  // namespace monoslam
