// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** Options shared by all strategies that search first and decide once, [association]. */
struct MONOSLAM_ASSOCIATION_EXPORT BatchOptions
{
    double gate_probability = 0.99;  ///< of a right match lying in its ellipse
    int first_stage = 12;            ///< landmarks searched first, which shrink the other gates;
                                     ///< 0 = one stage
    double first_stage_distance_px = 80.0;  ///< between two of them
    int first_stage_candidates = 3;         ///< of each of them, where the decision is a joint one
    int max_measured = 60;                  ///< landmarks searched in a frame
    double final_gate_probability = 0.999;  ///< test of each accepted pair given all others;
                                            ///< 1 = off
    int max_iterations =
        8;  ///< most linearisations of a frame's update; 1 = plain EKF (the papers)

    static BatchOptions from(const mrpt::config::CConfigFileBase& file,
                             const std::string& fileName);
};

class BatchSearch;

/** Pairs of one frame as the batch strategies see them: candidates[i] belong to rows[i]. */
struct AssociationProblem
{
    const Prediction* prediction = nullptr;
    std::vector<Eigen::Index> rows;
    std::vector<std::vector<Candidate>> candidates;  ///< non-empty, best score first
    std::vector<SearchRegion> regions;               ///< where candidates[i] were searched
    double imageArea_px2 = 640.0 * 480.0;
};

/** Searches all, decides once, updates once: NN, JCBB, HOHCT.
 *
 * The landmarks are searched in two stages: the oldest ones, well spread, in their own gates; what
 * select() accepts of them shrinks the gates of the rest,
 *
 *      S_j|a = S_j - HPHt_ja S_aa^-1 HPHt_aj,   centre = h_j + HPHt_ja S_aa^-1 nu_a
 *
 * The first gates are wide and hold what looks alike: a strategy that decides jointly among several
 * candidates gets first_stage_candidates of each, and what it rejects is searched once more in its
 * shrunken gate. Before that everything is linearised again at the mean that the accepted pairs give
 * (an iterated EKF) if they depart from the prior's linearisation: a fast turn bends the projection
 * by pixels, which joint tests would take for outliers.
 * Then select() decides over the pairs of both stages against the prior's joint S. Joint strategies
 * go through one more test: every accepted pair given all others, and every rejected pair given
 * the accepted ones, against chi2(2, final_gate_probability). */
class MONOSLAM_ASSOCIATION_EXPORT BatchAssociator : public Associator
{
   public:
    explicit BatchAssociator(const BatchOptions& options);
    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& rng) const final;

   protected:
    /** Of any landmark, in any stage. */
    [[nodiscard]] bool getsSeveralCandidates() const;

   private:
    /** Index of the accepted candidate for each entry of problem.rows, -1 = none. */
    [[nodiscard]] virtual std::vector<int> select(const AssociationProblem& problem,
                                                  AssociationCounters& counters) const = 0;
    [[nodiscard]] virtual int maxCandidates() const { return 1; }
    /** Whether select() finds the jointly compatible among several candidates of each landmark. */
    [[nodiscard]] virtual bool choosesAmongSeveral() const { return false; }
    /** Least score of a candidate; nothing: the search's own. */
    [[nodiscard]] virtual std::optional<double> minScore() const { return std::nullopt; }
    [[nodiscard]] virtual bool validatesJointly() const { return false; }
    [[nodiscard]] std::vector<int> decide(const AssociationProblem& problem,
                                          AssociationCounters& counters) const;

    [[nodiscard]] int firstStageCandidates() const;

    /** Both stages of search and decision: index of the accepted candidate of every pair found. */
    [[nodiscard]] std::vector<int> choose(BatchSearch& search, Belief& prior,
                                          const FrameView& view) const;

    BatchOptions options_;
    double gate_;
    double finalGate_;
};

/** The belief of a mixture of one. \throw std::logic_error if there are none or several */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT Belief& onlyBelief(Mixture& mixture);
}  // namespace monoslam
