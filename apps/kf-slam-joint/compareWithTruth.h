// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/CMatrixDynamic.h>
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <vector>

#include "Filter.h"

namespace monoslam
{
/** x y z yaw pitch roll of every step [m, rad], or nothing if no file is named.
 *  \throw std::runtime_error naming the file, if it has not six columns */
[[nodiscard]] std::vector<mrpt::poses::CPose3D> readTruePath(const std::string& file);

/** Root mean square and largest distance from the true positions, without alignment. */
struct PathErrors
{
    std::size_t steps = 0;  ///< that have a truth
    double rmse_m = 0.0;
    double largest_m = 0.0;
};

/** \param frames  row of the truth of each step: the first frames of a rawlog may have no action,
 *         and are then not among the steps */
[[nodiscard]] PathErrors comparePaths(const std::vector<mrpt::poses::CPose3D>& path,
                                      const std::vector<mrpt::poses::CPose3D>& truth,
                                      const std::vector<std::size_t>& frames);

/** One line: distances of the landmarks from those of the file of the same ID; from the nearest
 *  ones where the rawlog has no IDs, of which kf-slam would compare index with ID. */
[[nodiscard]] std::string landmarkErrors(const std::vector<MappedLandmark>& landmarks,
                                         const std::string& file, bool haveIds);
}  // namespace monoslam
