// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace monoslam
{
inline constexpr const char* kFiguresFile = "figures.json";  ///< of mono-slam-eval
inline constexpr const char* kRecordFile = "job.json";
inline constexpr const char* kLogFile = "log.txt";  ///< what the programs of a job print

/** What became of a job; as a file in its folder it says that the job need not run again. */
struct JobRecord
{
    bool done = false;  ///< else it failed
    int status = 0;     ///< exit status of the program that failed; 128 + signal, as in a shell
    std::string error;  ///< the last line that it printed
    std::optional<double> wall_s;
    nlohmann::ordered_json figures = nlohmann::ordered_json::object();  ///< name: number or text
};

/** \return nothing where the folder has no complete record */
[[nodiscard]] std::optional<JobRecord> readRecord(const std::string& folder);

/** Written last, when all other files of the folder are on the disk. */
void writeRecord(const std::string& folder, const JobRecord& record);

/** A record of what summary.json and, if \p evaluated, figures.json of a folder say. Figures of the
 *  summary are called run_NAME; all that are times begin with "time_".
 *  \throw std::runtime_error naming a file that is missing or damaged */
[[nodiscard]] JobRecord recordOf(const std::string& folder, bool evaluated);

/** A record of a program that ended with a status other than 0. */
[[nodiscard]] JobRecord failureOf(const std::string& folder, int status);
}  // namespace monoslam
