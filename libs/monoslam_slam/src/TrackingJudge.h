// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_slam/FrameReport.h"
#include "monoslam_slam/MapOptions.h"

namespace monoslam
{
/** Says of every frame whether its pose can be trusted, from what the run itself can see. */
class TrackingJudge
{
   public:
    explicit TrackingJudge(const MapOptions& options) : options_(options) {}

    /** Sets state and remark of a frame that was tracked.
     *  \param sigma_px  noise that the residuals show
     *  \param startUnexplained  whether no estimate explains the first seconds
     *  \param afterGap  whether the frame before did not tell where to search: what then matches
     *                   nothing is lost at once */
    void assess(FrameReport& report, double sigma_px, bool startUnexplained, bool afterGap);

    /** The map was begun anew: from now on pose and scale are guesses. */
    void noteRestart();

    /** The way back into a map that was lost was found.
     *  \param guessed  whether that one was begun after a loss, too */
    void noteReturn(bool guessed);

    /** Whether pose and scale are guesses since a loss. */
    [[nodiscard]] bool restarted() const { return restarted_; }

    /** Whether the frame before matched too little. */
    [[nodiscard]] bool poor() const { return poorFrames_ > 0; }

   private:
    MapOptions options_;
    int poorFrames_ = 0;          ///< in a row
    double rejectedShare_ = 0.0;  ///< running mean
    bool restarted_ = false;
};
}  // namespace monoslam
