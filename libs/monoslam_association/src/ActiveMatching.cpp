// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ConditionalPrediction.h"
#include "iteratedUpdate.h"
#include "matchActively.h"
#include "matchRest.h"
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/chooseSubset.h"
#include "monoslam_support/ConfigSection.h"
#include "monoslam_support/ThreadClock.h"
#include "relinearize.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
enum class Approximation
{
    None,    ///< Active Matching
    Tree,    ///< CLAM: correlations along a Chow-Liu tree only
    Subset,  ///< SubAM: the landmarks that tell most about the pose first, then the others
};

/** Active Matching, CLAM and SubAM: the pixels of a mixture's heaviest Gaussian, one update. */
class ActiveMatching : public Associator
{
   public:
    ActiveMatching(const BatchOptions& batch, ConfigSection section, Approximation approximation)
        : batch_(batch), approximation_(approximation), options_(MatchingOptions::from(section))
    {
        if (approximation == Approximation::Subset)
            subset_ = section.get("subset", subset_, {1.0, 1e6});
        section.rejectUnknownKeys();
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = true;
        t.multipleCandidates = options_.clutter.max_candidates > 1;
        t.hypothesesWithinFrame = true;
        return t;
    }

    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& /*rng*/) const override
    {
        Belief& belief = onlyBelief(predicted);
        ThreadClock clock;
        Correction correction;
        const Prediction prediction = view.predict(belief);
        AssociationCounters& counters = correction.counters;
        correction.associations = unsearched(prediction);
        counters.updateMs += clock.lap_ms();
        auto pixels = match(belief, prediction, view, correction);
        clock.lap_ms();
        if (!pixels.empty() && !updatable(prediction, pixels, counters.jointD2))
        {
            ++counters.faults;
            for (const auto& pixel : pixels)
                correction.associations[static_cast<std::size_t>(pixel.row)].fate = Fate::Rejected;
            pixels.clear();
        }
        finishRecords(prediction, correction);
        if (!pixels.empty())
        {
            int faults = 0;
            belief = iteratedUpdate({belief, prediction, {}}, pixels, view, batch_.max_iterations,
                                    faults);
            counters.faults += faults;
        }
        counters.updateMs += clock.lap_ms();
        correction.mixture = std::move(predicted);
        return correction;
    }

   private:
    static std::vector<Association> unsearched(const Prediction& prediction)
    {
        std::vector<Association> associations;
        for (const PredictedLandmark& row : prediction.rows)
        {
            Association& record = associations.emplace_back();
            record.id = row.id;
            record.h = record.z = row.h;
            record.S = row.S;
            record.R = row.R;
        }
        return associations;
    }

    [[nodiscard]] std::vector<PixelMeasurement> match(const Belief& belief,
                                                      const Prediction& prediction,
                                                      const FrameView& view,
                                                      Correction& correction) const
    {
        std::vector<Eigen::Index> rows = searchable(prediction);
        MatchingFrame frame{
            prediction,         view, rows, batch_.max_measured, correction.associations,
            correction.counters};
        if (approximation_ == Approximation::Tree)
            return matchActively(treePixels(prediction), options_, frame);
        if (approximation_ == Approximation::None)
            return matchActively(densePixels(prediction), options_, frame);
        frame.rows = chooseSubset(belief, prediction, rows, static_cast<std::size_t>(subset_));
        auto pixels = matchActively(densePixels(prediction), options_, frame);
        const auto isDone = [&](Eigen::Index row)
        { return std::find(frame.rows.begin(), frame.rows.end(), row) != frame.rows.end(); };
        rows.erase(std::remove_if(rows.begin(), rows.end(), isDone), rows.end());
        frame.max_measured -= static_cast<int>(frame.rows.size());
        frame.rows = std::move(rows);
        matchRest(frame, options_.clutter, pixels);
        return pixels;
    }

    /** Rows by landmark, without those that are no numbers. */
    static std::vector<Eigen::Index> searchable(const Prediction& prediction)
    {
        std::vector<Eigen::Index> rows;
        for (const auto& [id, row] : rowsById(prediction))
            if (prediction.rows[static_cast<std::size_t>(row)].h.allFinite()) rows.push_back(row);
        return rows;
    }

    /** NIS by the prior's S, and the counts of pairs. */
    static void finishRecords(const Prediction& prediction, Correction& correction)
    {
        for (std::size_t i = 0; i < correction.associations.size(); ++i)
        {
            Association& record = correction.associations[i];
            if (record.fate != Fate::Matched && record.fate != Fate::Rejected) continue;
            ++correction.counters.pairs;
            correction.counters.rejected += record.fate == Fate::Rejected ? 1 : 0;
            const PixelMeasurement pixel{static_cast<Eigen::Index>(i), record.z, record.R};
            record.nis = ConditionalPrediction(prediction, {pixel}).d2();
        }
    }

    BatchOptions batch_;
    Approximation approximation_;
    MatchingOptions options_;
    int subset_ = 10;  ///< SubAM: landmarks matched actively
};
}  // namespace

std::unique_ptr<Associator> makeActiveMatching(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<ActiveMatching>(
        BatchOptions::from(file, fileName),
        ConfigSection(file, "association.active_matching", fileName), Approximation::None);
}

std::unique_ptr<Associator> makeClam(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<ActiveMatching>(BatchOptions::from(file, fileName),
                                            ConfigSection(file, "association.clam", fileName),
                                            Approximation::Tree);
}

std::unique_ptr<Associator> makeSubam(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<ActiveMatching>(BatchOptions::from(file, fileName),
                                            ConfigSection(file, "association.subam", fileName),
                                            Approximation::Subset);
}
}  // namespace monoslam
