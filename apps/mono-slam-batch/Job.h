// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Batch.h"

namespace monoslam
{
/** One run of mono-slam, and of mono-slam-eval where something can be evaluated. */
struct Job
{
    std::string sequence;
    std::string strategy;
    std::string variant;
    unsigned seed = 1;
    std::string origin;                 ///< the sections that it comes from, for messages
    std::vector<std::string> slam;      ///< arguments of mono-slam, without seed and output
    std::vector<std::string> evaluate;  ///< arguments of mono-slam-eval, without the run; or empty

    /** SEQUENCE/STRATEGY/VARIANT/seed-N-KEY within the output folder. KEY stands for all that
     *  decides the result, so that what a folder holds never is of another configuration. */
    std::string folder;
};

/** The jobs in their order: sequences, strategies, variants, seeds, the last changing fastest. */
[[nodiscard]] std::vector<Job> expandJobs(const Batch& batch);
}  // namespace monoslam
