// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "monoslam_association/export.h"
#include "monoslam_filter/Belief.h"
#include "monoslam_filter/FilterEngine.h"
#include "monoslam_filter/ekf.h"
#include "monoslam_filter/predictMeasurements.h"

namespace mrpt::config
{
class CConfigFileBase;
}

namespace monoslam
{
/** A place in the image that looks like a landmark. */
struct Candidate
{
    Eigen::Vector2d z;   ///< [px]
    double score = 1.0;  ///< ZNCC in [-1, 1]
    Eigen::Matrix2d R;   ///< noise of z [px^2]
};

/** Where to look for one landmark: the ellipse (z - centre)' S^-1 (z - centre) < gate. */
struct SearchRegion
{
    LandmarkId id = -1;
    Eigen::Vector2d centre;   ///< [px]
    Eigen::Matrix2d S;        ///< [px^2]
    double gate = 5.9915;     ///< chi2(2, P_search)
    int maxCandidates = 1;    ///< best scores first
};

enum class SearchStatus
{
    Done,           ///< searched; candidates may be empty
    Unpredictable,  ///< the view is too different from the stored appearance, or outside the image
    Refused,        ///< the region is too large to search
};

struct SearchResult
{
    SearchStatus status = SearchStatus::Done;
    std::vector<Candidate> candidates;
    long pixels = 0;  ///< positions correlated
};

/** All that a strategy may ask of a frame; tests fill it with two lambdas. */
struct FrameView
{
    std::function<Prediction(const Belief&)> predict;
    std::function<SearchResult(const SearchRegion&)> search;
    FilterEngine engine;
    /** Optional: pixel of a landmark from another mean; without it second-stage regions are linear. */
    std::function<std::optional<Eigen::Vector2d>(const Eigen::VectorXd& x, const PredictedLandmark&)>
        project = {};
};

/** What became of one visible landmark in one frame. */
enum class Fate
{
    NotSearched,  ///< visible, but its region was refused, unpredictable or left out
    NotFound,     ///< searched, nothing looked like it
    Rejected,     ///< found, but the association was judged wrong
    Matched,      ///< found and used in the update
};

struct Association
{
    LandmarkId id = -1;
    Fate fate = Fate::NotSearched;
    Eigen::Vector2d h;    ///< prediction [px]
    Eigen::Matrix2d S;    ///< of the region that was searched [px^2]
    Eigen::Vector2d z;    ///< chosen pixel, if Rejected or Matched [px]
    Eigen::Matrix2d R;    ///< its noise [px^2]
    double score = 0.0;
    double nis = 0.0;     ///< nu' S^-1 nu with the prior's S
};

/** The numbers that the papers' tables are about. */
struct AssociationCounters
{
    long pixelsCorrelated = 0;
    long searches = 0;      ///< image searches
    long pairs = 0;         ///< n: pairs that went into validation
    long rejected = 0;      ///< r
    long jointSearches = 0; ///< calls in which the full set was not compatible
    long nodes = 0;
    long leaves = 0;
    long d2Evaluations = 0;
    long faults = 0;        ///< indefinite S met in the update
    bool provedOptimal = true;
    double jointD2 = 0.0;   ///< of the accepted set
    double searchMs = 0.0;  ///< thread CPU time of image search
    double selectMs = 0.0;  ///< of association proper
    double updateMs = 0.0;  ///< of predicted measurements and filter update
};

struct Correction
{
    Mixture mixture;
    std::vector<Association> associations;  ///< of the belief of largest weight
    AssociationCounters counters;
};

/** The columns of the second paper's Table 1. */
struct AssociatorTraits
{
    bool spatial = false;
    bool appearance = false;
    bool multipleCandidates = false;
    bool hypothesesWithinFrame = false;
    bool hypothesesBetweenFrames = false;
};

/** Association strategy: from a predicted mixture and a frame to the corrected mixture.
 *  Strategies are const; what outlives a frame is in the Mixture. */
class MONOSLAM_ASSOCIATION_EXPORT Associator
{
   public:
    virtual ~Associator() = default;
    [[nodiscard]] virtual AssociatorTraits traits() const = 0;
    [[nodiscard]] virtual Correction correct(Mixture predicted, const FrameView& view,
                                             std::mt19937& rng) const = 0;
};

/** Options shared by all strategies that search first and decide once, [association]. */
struct MONOSLAM_ASSOCIATION_EXPORT BatchOptions
{
    double gate_probability = 0.99;   ///< of a right match lying in its ellipse
    int first_stage = 12;             ///< landmarks searched first, which shrink the other gates; 0 = one stage
    double first_stage_distance_px = 80.0;  ///< between two of them
    int max_measured = 60;            ///< landmarks searched in a frame
    double final_gate_probability = 0.999;  ///< test of each accepted pair given all others; 1 = off

    static BatchOptions from(const mrpt::config::CConfigFileBase& file, const std::string& fileName);
};

class BatchSearch;

/** Pairs of one frame as the batch strategies see them: candidates[i] belong to rows[i]. */
struct AssociationProblem
{
    const Prediction* prediction = nullptr;
    std::vector<Eigen::Index> rows;
    std::vector<std::vector<Candidate>> candidates;  ///< non-empty, best score first
    std::vector<SearchRegion> regions;               ///< where candidates[i] were searched
};

/** Searches all, decides once, updates once: NN, JCBB, HOHCT.
 *
 * The landmarks are searched in two stages: the oldest ones, well spread, in their own gates; what
 * select() accepts of them shrinks the gates of the rest,
 *
 *      S_j|a = S_j - HPHt_ja S_aa^-1 HPHt_aj,   centre = h_j + HPHt_ja S_aa^-1 nu_a
 *
 * Then select() decides over the pairs of both stages against the prior's joint S. Joint strategies
 * go through one more test: every accepted pair given all others, and every rejected pair given
 * the accepted ones, against chi2(2, final_gate_probability). */
class MONOSLAM_ASSOCIATION_EXPORT BatchAssociator : public Associator
{
   public:
    explicit BatchAssociator(const BatchOptions& options);
    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& rng) const final;

   private:
    /** Index of the accepted candidate for each entry of problem.rows, -1 = none. */
    [[nodiscard]] virtual std::vector<int> select(const AssociationProblem& problem,
                                                  AssociationCounters& counters) const = 0;
    [[nodiscard]] virtual int maxCandidates() const { return 1; }
    [[nodiscard]] virtual bool validatesJointly() const { return false; }
    [[nodiscard]] std::vector<int> decide(const AssociationProblem& problem,
                                          AssociationCounters& counters) const;

    /** Both stages of search and decision: index of the accepted candidate of every pair found. */
    [[nodiscard]] std::vector<int> choose(BatchSearch& search) const;

    BatchOptions options_;
    double gate_;
    double finalGate_;
};

using AssociatorFactory = std::function<std::unique_ptr<Associator>(
    const mrpt::config::CConfigFileBase& file, const std::string& fileName)>;

/** Adds or replaces a strategy; plugins call it too. */
MONOSLAM_ASSOCIATION_EXPORT void registerAssociator(const std::string& name,
                                                    AssociatorFactory factory);
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::vector<std::string> associatorNames();

/** \throw std::invalid_argument on an unknown name, listing the known ones. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::unique_ptr<Associator> makeAssociator(
    const std::string& name, const mrpt::config::CConfigFileBase& file,
    const std::string& fileName = {});
}  // namespace monoslam
