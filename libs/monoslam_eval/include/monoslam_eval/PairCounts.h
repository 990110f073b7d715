// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_eval/PixelFeatures.h"
#include "monoslam_eval/export.h"

namespace monoslam
{
/** Pairs of one or more frames judged by the features' truth. */
struct MONOSLAM_EVAL_EXPORT PairCounts
{
    long right = 0;      ///< matched with the landmark's own image
    long wrong = 0;      ///< matched with anything else
    long available = 0;  ///< landmarks predicted in view whose own image is among the features

    void add(const std::vector<Association>& associations, const PixelFrame& frame);

    /** Share of the matches that are right; NaN without matches. */
    [[nodiscard]] double precision() const;
    /** Share of the available images that were matched; NaN without any. */
    [[nodiscard]] double recall() const;
};
}  // namespace monoslam
