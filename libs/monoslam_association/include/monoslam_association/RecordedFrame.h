// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_association/export.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
/** What was found of one landmark in a frame. */
struct RecordedLandmark
{
    LandmarkId id = -1;
    SearchStatus status = SearchStatus::Done;
    std::vector<Candidate> candidates;  ///< best score first
    /** Index of the right candidate, -1 = none of them is right; nothing: it is not known. */
    std::optional<int> truth;
    /** From the belief of largest weight; nothing if that does not see it. S with the R of the
     *  visibility options. */
    std::optional<PredictedLandmark> predicted;
};

/** How much of a frame is recorded: more than any strategy is likely to ask for. */
struct RecordLimits
{
    double gate = 18.42;     ///< of the ellipses searched: chi2(2, 0.9999)
    double minScore = 0.5;   ///< of a candidate
    int maxCandidates = 50;  ///< of a landmark
};

/** The association problem of one frame, apart from its image: what a strategy may ask is answered
 *  from the predicted beliefs, the camera and the candidates that were found. */
struct MONOSLAM_ASSOCIATION_EXPORT RecordedFrame
{
    long index = 0;   ///< number in the recording
    Mixture mixture;  ///< as predicted for the frame
    Camera camera;
    VisibilityOptions visibility;
    double minScore = 0.8;  ///< of a candidate where a strategy does not say
    RecordLimits limits;
    std::vector<RecordedLandmark> landmarks;

    /** The frame as a strategy sees it. Candidates are those recorded in the region that is asked
     *  for, best score first; the pixels correlated are taken to be as many as the region's area.
     *  A landmark that is not recorded cannot be searched. Must not outlive this object. */
    [[nodiscard]] FrameView view() const;

    /** Predicts again and compares with what is recorded.
     *  \throw std::invalid_argument naming landmark and quantity if they disagree, or if a belief
     *  breaks its invariant */
    void check() const;
};

/** Searches every landmark that a belief of \p mixture sees, in the ellipse of that belief. The
 *  camera, visibility and minScore of \p frame are those of \p view and stay; the rest is filled. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT RecordedFrame recordFrame(RecordedFrame frame,
                                                                    const FrameView& view);

/** Lets a strategy solve the frame once, and records what the image answered. In a strategy's own,
 *  smaller ellipses an image may show other peaks, at their borders, and a coarse search may miss one:
 *  the record has the same there, or the strategy would find in it what it did not find in the image.
 *  \param rng  as the strategy will use it */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT RecordedFrame withAnswers(RecordedFrame frame,
                                                                    const FrameView& view,
                                                                    const Associator& strategy,
                                                                    std::mt19937 rng);
}  // namespace monoslam
