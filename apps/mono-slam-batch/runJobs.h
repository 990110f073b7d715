// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Job.h"
#include "results.h"

namespace monoslam
{
/** Where and how the jobs of a batch run. */
struct RunOptions
{
    std::string programs;  ///< folder of mono-slam and mono-slam-eval
    std::string output;    ///< folder of the batch
    std::size_t slots = 1;
};

/** Writes results.csv of what is known so far. */
void writeResults(const std::string& output, const std::vector<Job>& jobs,
                  const JobRecords& records);

/** Runs the jobs without a record and records them, on the disk as well; keeps results.csv up to
 *  date. Ends early when a signal comes. */
void runJobs(const std::vector<Job>& jobs, JobRecords& records, const RunOptions& options);
}  // namespace monoslam
