// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/RecordedFrame.h"
#include "monoslam_eval/export.h"

namespace monoslam
{
/** What a strategy made of one association problem, and how it compares with the truth. */
struct Solution
{
    Correction correction;
    long accepted = 0;        ///< pairs used in the update, of the belief of largest weight
    long rejected = 0;        ///< landmarks with candidates that got none
    double d2 = 0.0;          ///< joint D2 of the accepted pairs by the belief as predicted
    double associate_ms = 0;  ///< CPU time of association proper, of all threads
    double total_ms = 0.0;    ///< with search and update

    bool truthKnown = false;  ///< of every landmark; the rest is 0 without
    long right = 0;           ///< accepted pairs that are right
    long present = 0;         ///< landmarks that have a right candidate

    /** No accepted pair is wrong. */
    [[nodiscard]] bool jointlyCorrect() const { return right == accepted; }
    /** And none of the right ones is missed. */
    [[nodiscard]] bool complete() const { return jointlyCorrect() && right == present; }
};

/** A strategy that carries one belief gets the one of largest weight.
 *  \throw std::logic_error if the strategy accepts what is no candidate of the landmark */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Solution solveProblem(const Associator& associator,
                                                         const RecordedFrame& frame, unsigned seed);
}  // namespace monoslam
