// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "Method.h"
#include "monoslam_eval/FeatureSlam.h"
#include "monoslam_eval/PairCounts.h"

namespace monoslam
{
inline constexpr int kLandmarks = 18;                             ///< beside the target's four
inline constexpr int kGroupBegins = 60;                           ///< frame; the map has settled
inline constexpr int kFramesToRecover = 30;                       ///< after the group's end
inline constexpr int kFramesJudged = 10;                          ///< the last of them
inline const std::vector<int> kDurations{0, 1, 2, 3, 5, 10, 20};  ///< [frames]; 0 = no group

/** What the group of wrong matches is like. */
struct Disturbance
{
    WrongMatchesOptions::Kind kind = WrongMatchesOptions::Kind::Offset;
    bool hide_true = true;
};

/** One run of a method over one seed and duration. */
struct Outcome
{
    double worst_m = 0.0;      ///< position error, from the group's beginning to its end
    double after_m = 0.0;      ///< rms position error of the frames judged
    double reference_m = 0.0;  ///< of the same frames, association known and no group
    long wrongMatched = 0;     ///< pairs of the group's landmarks with what is not their image
    double frame_ms = 0.0;     ///< thread CPU time a frame

    /** At most twice the error of known association, or 1 mm more than it. */
    [[nodiscard]] bool recovered() const;
};

/** The outcome of every duration, of one seed: a common beginning with known association, then a
 *  branch for each. */
[[nodiscard]] std::vector<Outcome> disturbedRuns(const Method& method,
                                                 const Disturbance& disturbance, unsigned seed);
}  // namespace monoslam
