// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "LandmarkTruth.h"
#include "RunOutput.h"
#include "monoslam_eval/metrics.h"

namespace monoslam
{
/** One row of the table for one run. */
struct Figure
{
    std::string key;     ///< in JSON and CSV, with its unit
    std::string label;   ///< in the table, with its unit
    double value = 0.0;  ///< NaN = not available
    int decimals = 3;
};

/** Figures of one run against ground truth; every run has the same rows. */
[[nodiscard]] std::vector<Figure> figuresAgainst(const RunOutput& run, const Trajectory& truth,
                                                 const TimeMatchingOptions& options);

/** Errors of the landmarks, moved as the trajectory is, against the surface points that their first
 *  pixels show: distances [m] and relative to the distance from the camera of then [%]. */
[[nodiscard]] std::vector<Figure> landmarkFigures(const RunOutput& run,
                                                  const std::vector<PosePair>& pairs,
                                                  LandmarkTruth& truth);

/** errors.csv in a run's folder: of each pose that has a true one its errors, NEES and position.
 *
 * NEES (6 numbers) is that of the frame in which the covariance is meant: unaligned for None,
 * otherwise with the first pose taken to the true one, for Sim3 with the fitted scale.
 * \throw std::runtime_error if it cannot be written */
void writeErrors(const RunOutput& run, const std::vector<PosePair>& pairs, Alignment alignment);

/** Figures of a path out and back along a line, without ground truth. */
[[nodiscard]] std::vector<Figure> figuresOutAndBack(const RunOutput& run);

/** Runs as columns, figures as rows. */
struct Table
{
    std::vector<std::string> names;
    std::vector<std::vector<Figure>> columns;
};
void printTable(std::ostream& out, const Table& table);
void printCsv(std::ostream& out, const Table& table);
void printJson(std::ostream& out, const Table& table);
}  // namespace monoslam
