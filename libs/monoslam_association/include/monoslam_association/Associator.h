// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "monoslam_association/Diversity.h"
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
    Eigen::Vector2d centre;          ///< [px]
    Eigen::Matrix2d S;               ///< [px^2]
    double gate = 5.9915;            ///< chi2(2, P_search)
    int maxCandidates = 1;           ///< best scores first
    std::optional<double> minScore;  ///< instead of the search's own
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

/** All that a strategy may ask of a frame; tests fill it with three lambdas. A strategy with several
 *  threads calls them from all of them at once. */
struct FrameView
{
    std::function<Prediction(const Belief&)> predict;
    /** h, H and R at a mean x, S unset; nothing if the landmark is not visible from there. */
    std::function<std::optional<PredictedLandmark>(const Eigen::VectorXd& x, const LandmarkSlot&)>
        linearize;
    std::function<SearchResult(const SearchRegion&)> search;
    FilterEngine engine;
    double imageArea_px2 = 640.0 * 480.0;  ///< over which wrong candidates are spread
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
    Eigen::Vector2d h;  ///< prediction [px]
    Eigen::Matrix2d S;  ///< of the region that was searched [px^2]
    Eigen::Vector2d z;  ///< chosen pixel, if Rejected or Matched [px]
    Eigen::Matrix2d R;  ///< its noise [px^2]
    double score = 0.0;
    double nis = 0.0;  ///< nu' S^-1 nu with the prior's S
};

/** The numbers that the papers' tables are about. */
struct AssociationCounters
{
    long pixelsCorrelated = 0;
    long searches = 0;       ///< image searches
    long pairs = 0;          ///< n: pairs that went into validation
    long rejected = 0;       ///< r
    long jointSearches = 0;  ///< calls in which the full set was not compatible
    long nodes = 0;
    long leaves = 0;
    long d2Evaluations = 0;
    long faults = 0;  ///< indefinite S met in the update
    bool provedOptimal = true;
    long capped = 0;        ///< searches that a time cap ended: the strategy's fallback went on
    double jointD2 = 0.0;   ///< of the accepted set
    double searchMs = 0.0;  ///< thread CPU time of image search
    double selectMs = 0.0;  ///< of association proper
    double updateMs = 0.0;  ///< of predicted measurements and filter update
    double otherThreadsMs = 0.0;  ///< of the three above, not spent in the calling thread
};

/** Images, pixels, nodes, faults and times are summed over all beliefs of the mixture; pairs and
 *  rejected are those of the belief of largest weight. */
struct Correction
{
    Mixture mixture;
    std::vector<Association> associations;  ///< of the belief of largest weight
    AssociationCounters counters;
    /** Associations of each belief, and the index of the predicted belief that it comes from; both
     *  empty if the mixture is one belief before and after. */
    std::vector<std::vector<Association>> ofEveryBelief = {};
    std::vector<std::size_t> parents = {};
    Diversity diversity = {};
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
    /** False if it corrects pixel by pixel itself, without FrameView::engine. */
    [[nodiscard]] virtual bool updatesByEngine() const { return true; }
    [[nodiscard]] virtual Correction correct(Mixture predicted, const FrameView& view,
                                             std::mt19937& rng) const = 0;
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
