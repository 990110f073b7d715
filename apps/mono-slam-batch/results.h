// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "Job.h"
#include "JobRecord.h"

namespace monoslam
{
/** A record a job, in the jobs' order; none where the job has not ended. */
using JobRecords = std::vector<std::optional<JobRecord>>;

/** One row a job in the jobs' order, RFC 4180. Status is done, failed or pending; an unknown figure
 *  is an empty field. The figures' columns come in the order in which the jobs, one after the
 *  other, name them, so that it does not matter which job ended first. */
[[nodiscard]] std::string resultsCsv(const std::vector<Job>& jobs, const JobRecords& records);
}  // namespace monoslam
