// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/RecordedFrame.h"
#include "monoslam_eval/export.h"

namespace monoslam
{
struct ProblemShape
{
    int landmarks = 25;  ///< m, all visible
    int candidates = 1;  ///< of each
    int absent = 0;      ///< r: landmarks all of whose candidates are wrong
};

/** What is drawn; standard deviations unless said otherwise. */
struct ProblemDistributions
{
    double dt_s = 1.0 / 30.0;        ///< since the landmarks were first seen
    double position_m = 0.01;        ///< of the first pose, each axis
    double orientation_rad = 0.005;  ///< of the first pose, about each axis
    double speed_mps = 0.3;          ///< of the mean velocity, each axis
    double turning_radps = 0.2;      ///< of the mean turn rate, about each axis
    double velocity_mps = 0.1;       ///< of the belief about the velocity, each axis
    double turnRate_radps = 0.1;     ///< of the belief about the turn rate, about each axis
    double nearest_per_m = 1.0;      ///< inverse depths are this, four fifths, ... one fifth of it
    double rhoShare = 0.05;          ///< of an inverse depth, relative to it
    double sigma_px = 1.0;           ///< of a pixel
    double border_px = 80.0;         ///< first pixels are uniform so far inside the image
    double gateProbability = 0.99;   ///< right pixels lie in this ellipse, wrong ones uniform in it
    double wrongDistance_px = 3.0;   ///< of a wrong pixel from the right one, at least
    double rightScore = 0.92;        ///< mean of a normal distribution cut at minScore and 1
    double rightScoreSigma = 0.04;
    double wrongScore = 0.82;  ///< the same of a wrong candidate
    double wrongScoreSigma = 0.06;
    double minScore = 0.7;
};

/** An association problem with its truth: a camera that saw m inverse-depth landmarks for the first
 *  time and has moved for dt_s, so that their predictions share six uncertain numbers of motion.
 *
 * Truth is drawn as the belief says: first pose, velocities, inverse depths, first pixels, impulses
 * of the motion model, pixel noise. A frame in which a landmark leaves the image or a right pixel
 * its ellipse is drawn anew. Same shape and seed, same bits.
 * \throw std::invalid_argument if there are fewer landmarks than absent ones, or no candidates */
[[nodiscard]] MONOSLAM_EVAL_EXPORT RecordedFrame
drawProblem(const ProblemShape& shape, unsigned seed, const ProblemDistributions& drawn = {});
}  // namespace monoslam
