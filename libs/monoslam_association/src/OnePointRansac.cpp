// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "BatchSearch.h"
#include "bestCandidates.h"
#include "iteratedUpdate.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ConfigSection.h"
#include "monoslam_support/ThreadClock.h"
#include "oneMatchConsensus.h"
#include "relinearize.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** Options of [association.one_point_ransac]. */
struct OnePointRansacOptions
{
    ConsensusOptions consensus;
    double tau = 0.99;              ///< of the rescue's gate
    bool rescue_without_R = false;  ///< leave R out of the rescue's S, as the public code does

    static OnePointRansacOptions from(const IniFile& file, const std::string& fileName);
};

OnePointRansacOptions OnePointRansacOptions::from(const IniFile& file, const std::string& fileName)
{
    ConfigSection section(file, "association.one_point_ransac", fileName);
    OnePointRansacOptions o;
    o.consensus.th_sigma = section.get("th_sigma", o.consensus.th_sigma, {1e-3, 1e3});
    o.consensus.p = section.get("p", o.consensus.p, {1e-6, 1.0 - 1e-12});
    o.tau = section.get("tau", o.tau, {1e-6, 1.0 - 1e-12});
    o.rescue_without_R = section.get("rescue_without_R", o.rescue_without_R);
    o.consensus.enumerate_up_to =
        section.get("enumerate_up_to", o.consensus.enumerate_up_to, {0.0, 1e6});
    section.rejectUnknownKeys();
    return o;
}

/** 1-point RANSAC EKF: an update with the inliers of the best one-match hypothesis, then one with
 *  what the individual gates of the updated belief rescue.
 *  \see Civera, Grasa, Davison, Montiel, "1-point RANSAC for EKF-based structure from motion",
 *       IROS 2009 */
class OnePointRansac : public Associator
{
   public:
    OnePointRansac(const BatchOptions& batch, const OnePointRansacOptions& options)
        : batch_(batch),
          options_(options),
          gate_(chi2Limit(2, batch.gate_probability)),
          rescueGate_(chi2Limit(2, options.tau))
    {
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = true;
        t.hypothesesWithinFrame = true;
        return t;
    }

    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& rng) const override
    {
        Belief& belief = onlyBelief(predicted);
        ThreadClock clock;
        BatchSearch search(view.predict(belief), view, {gate_, 1, 1, batch_, {}});
        search.counters.updateMs += clock.lap_ms();
        std::vector<int> chosen =
            searchInStages(search, belief, view,
                           [&](BatchSearch& s) {
                               return largestConsensus({belief, view, s.problem()},
                                                       options_.consensus, s.counters, rng);
                           });
        clock.lap_ms();
        belief = updateTwice(belief, search, view, chosen);
        recordPairs(search.problem(), chosen, search.associations);
        AssociationCounters& counters = search.counters;
        counters.updateMs += clock.lap_ms();
        counters.pairs = static_cast<long>(chosen.size());
        counters.rejected = std::count(chosen.begin(), chosen.end(), -1);
        return {std::move(predicted), std::move(search.associations), counters};
    }

   private:
    /** Both updates; what is rescued or cannot be used is changed in \p chosen. */
    [[nodiscard]] Belief updateTwice(Belief& prior, BatchSearch& search, const FrameView& view,
                                     std::vector<int>& chosen) const
    {
        AssociationCounters& counters = search.counters;
        const auto inliers = pixelsOf(search.problem(), chosen);
        if (inliers.empty()) return prior;
        if (!updatable(search.prediction(), inliers, counters.jointD2))
        {
            ++counters.faults;
            chosen.assign(chosen.size(), -1);
            return prior;
        }
        int faults = 0;
        Belief updated = iteratedUpdate({prior, search.prediction(), search.linearizedAt}, inliers,
                                        view, batch_.max_iterations, faults);
        const Prediction again = view.predict(updated);
        std::vector<int> rescuedToo = chosen;
        const auto rescued = rescue(search.problem(), again, rescuedToo, counters);
        double d2 = 0.0;
        if (!rescued.empty() && updatable(again, rescued, d2))
        {
            chosen = std::move(rescuedToo);
            updated = view.engine.update(std::move(updated), again, rescued, &faults);
        }
        counters.faults += faults;
        return updated;
    }

    /** Matches left out that lie in the individual gates of the updated belief; put into \p chosen. */
    [[nodiscard]] std::vector<PixelMeasurement> rescue(const AssociationProblem& problem,
                                                       const Prediction& again,
                                                       std::vector<int>& chosen,
                                                       AssociationCounters& counters) const
    {
        const std::map<LandmarkId, Eigen::Index> rowOf = rowsById(again);
        std::vector<PixelMeasurement> rescued;
        for (std::size_t i = 0; i < chosen.size(); ++i)
        {
            const auto before = static_cast<std::size_t>(problem.rows[i]);
            const auto row = rowOf.find(problem.prediction->rows[before].id);
            if (chosen[i] >= 0 || row == rowOf.end()) continue;
            const Candidate& candidate = problem.candidates[i].front();
            Eigen::Matrix2d S = again.HPHt.block<2, 2>(2 * row->second, 2 * row->second);
            if (!options_.rescue_without_R) S += candidate.R;
            const Eigen::Vector2d nu =
                candidate.z - again.rows[static_cast<std::size_t>(row->second)].h;
            ++counters.d2Evaluations;
            if (!positiveDefinite(S) || !(nu.dot(S.inverse() * nu) < rescueGate_)) continue;
            rescued.push_back({row->second, candidate.z, candidate.R});
            chosen[i] = 0;
        }
        return rescued;
    }

    BatchOptions batch_;
    OnePointRansacOptions options_;
    double gate_;
    double rescueGate_;
};
}  // namespace

std::unique_ptr<Associator> makeOnePointRansac(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<OnePointRansac>(BatchOptions::from(file, fileName),
                                            OnePointRansacOptions::from(file, fileName));
}
}  // namespace monoslam
