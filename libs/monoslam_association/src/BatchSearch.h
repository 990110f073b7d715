// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "monoslam_association/BatchAssociator.h"

namespace monoslam
{
class ConditionalPrediction;

/** The image searches of one frame of a batch strategy, and the pairs they bring.
 *
 * Orders are by landmark id, so that the order of the landmarks in the state changes nothing. */
class BatchSearch
{
   public:
    struct Settings
    {
        double gate = 5.9915;
        int maxCandidates = 1;
        int firstStageCandidates = 1;
        BatchOptions options;
        std::optional<double> minScore;  ///< of a candidate; nothing: the search's own
    };

    BatchSearch(Prediction prediction, const FrameView& view, const Settings& settings);
    ~BatchSearch() = default;
    BatchSearch(const BatchSearch&) = delete;
    BatchSearch& operator=(const BatchSearch&) = delete;
    BatchSearch(BatchSearch&&) = delete;
    BatchSearch& operator=(BatchSearch&&) = delete;

    /** The oldest landmarks that are far enough from each other, in their own gates. */
    void searchFirstStage();
    /** The others, farthest from the searched ones first, in gates given the accepted pairs; before
     *  them, once more, what was found and rejected.
     *  \param accepted  of every pair found; after this call, of those that were there before
     *  \return whether there are pairs to decide about that were not there before */
    bool searchRest(std::vector<int>& accepted);

    /** Goes on with another prediction of the same frame; pairs and records follow by landmark. */
    void moveTo(Prediction prediction);

    [[nodiscard]] const Prediction& prediction() const { return prediction_; }
    [[nodiscard]] const AssociationProblem& problem() const { return problem_; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    /** Records of every row of the prediction, and the search counters. */
    std::vector<Association> associations;
    AssociationCounters counters;
    Eigen::VectorXd linearizedAt;  ///< state at which prediction() is linearised; empty: the prior

   private:
    [[nodiscard]] SearchRegion ownRegion(Eigen::Index row) const;
    [[nodiscard]] SearchRegion regionGiven(const ConditionalPrediction& accepted,
                                           Eigen::Index row) const;
    void listRows();
    [[nodiscard]] const PredictedLandmark& at(Eigen::Index row) const;
    bool search(Eigen::Index row, SearchRegion region, int maxCandidates);
    void keepChosen(std::vector<int>& accepted);
    [[nodiscard]] std::vector<double> spreads() const;
    void searchRejectedAgain(const std::vector<int>& accepted, const ConditionalPrediction& given);
    void pickSpread(const std::function<SearchRegion(Eigen::Index)>& regionOf);

    Prediction prediction_;
    const FrameView& view_;
    Settings settings_;
    AssociationProblem problem_;
    std::vector<Eigen::Index> untried_;      ///< rows, by landmark id
    std::vector<Eigen::Vector2d> searched_;  ///< predicted pixels of the rows searched so far
};

/** Accepted candidate of every pair that a search has found so far, -1 = none. */
using DecideFn = std::function<std::vector<int>(BatchSearch&)>;

/** Searches the first stage and decides; linearises again at the mean that the accepted pairs give if
 *  the prediction is not linear as far as there; searches the rest in shrunken gates and decides over
 *  all. The first stage's mean is no estimate to linearise at without need: it is a few pairs' and
 *  wanders where they say little. \return the last decision */
[[nodiscard]] std::vector<int> searchInStages(BatchSearch& search, Belief& prior,
                                              const FrameView& view, const DecideFn& decide);

/** Fate, pixel, score and NIS of every pair that went into validation. */
void recordPairs(const AssociationProblem& problem, const std::vector<int>& chosen,
                 std::vector<Association>& associations);

/** Pixels chosen in a problem, -1 = none. */
[[nodiscard]] std::vector<PixelMeasurement> pixelsOf(const AssociationProblem& problem,
                                                     const std::vector<int>& chosen);

/** The last test of an accepted set; pairs are taken out and put back in \p chosen.
 *
 * While the worst NIS of an accepted pair given all others exceeds \p limit that pair is removed.
 * Then every pair left out whose NIS given the accepted set is within the limit is put back, if at
 * least three are accepted and its pixel is free. Joint tests of many pairs absorb weak outliers
 * and sacrifice neighbours of strong ones; this test does neither. */
void applyFinalGate(const AssociationProblem& problem, double limit, std::vector<int>& chosen);
}  // namespace monoslam
