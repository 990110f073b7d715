// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
/** MRPT's JCBB on the pixels of a frame, [association.jcbb_mrpt]: the baseline of the second paper.
 *
 * It has no joint test: with one candidate each it accepts all that pass their own gate. A pixel was
 * found by the appearance of one landmark and may be paired with no other; MRPT has no word for
 * that, so landmarks and pixels get a third coordinate that keeps them apart.
 *
 * With several candidates its time grows exponentially, and it cannot be told to stop: it runs in a
 * child process that ends with the frame's CPU time; there it pays some milliseconds for pages that
 * are new to the process. At the end of its time every landmark takes the nearest candidate
 * in its own gate, as many pairs as MRPT's largest set has: it maximises their number, and compares
 * D2 only among equals. Such a search is counted as capped and as not proved. */
class JcbbMrpt : public BatchAssociator
{
   public:
    JcbbMrpt(const BatchOptions& batch, ConfigSection section);

    [[nodiscard]] AssociatorTraits traits() const override;

   private:
    [[nodiscard]] int maxCandidates() const override { return maxCandidates_; }
    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override;
    [[nodiscard]] std::vector<int> nearest(const AssociationProblem& problem) const;

    double tau_;
    double cap_ms_ = 2000.0;  ///< CPU time of a frame; 0 = no cap, in this process
    int maxCandidates_ = 1;
};
}  // namespace monoslam
