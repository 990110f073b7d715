// SPDX-License-Identifier: BSD-3-Clause
#include "compareWithTruth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace monoslam
{
using mrpt::poses::CPose3D;

namespace
{
mrpt::math::CMatrixDouble readTable(const std::string& file, int columns)
{
    mrpt::math::CMatrixDouble table;
    table.loadFromTextFile(file);
    if (table.rows() == 0 || table.cols() < columns)
        throw std::runtime_error(file + ": expected " + std::to_string(columns) + " columns");
    return table;
}

double distanceToTruth(const MappedLandmark& landmark, const mrpt::math::CMatrixDouble& truth,
                       bool haveIds)
{
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row < truth.rows(); ++row)
    {
        if (haveIds && std::lround(truth(row, 6)) != landmark.id) continue;
        least = std::min(least, std::hypot(landmark.position.x - truth(row, 0),
                                           landmark.position.y - truth(row, 1),
                                           landmark.position.z - truth(row, 2)));
    }
    return least;
}
}  // namespace

std::vector<CPose3D> readTruePath(const std::string& file)
{
    std::vector<CPose3D> path;
    if (file.empty()) return path;
    const auto table = readTable(file, 6);
    for (int i = 0; i < table.rows(); ++i)
        path.emplace_back(table(i, 0), table(i, 1), table(i, 2), table(i, 3), table(i, 4),
                          table(i, 5));
    return path;
}

PathErrors comparePaths(const std::vector<CPose3D>& path, const std::vector<CPose3D>& truth,
                        const std::vector<std::size_t>& frames)
{
    PathErrors errors;
    double squares = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        if (frames[i] >= truth.size()) continue;
        const double error_m = path[i].distanceTo(truth[frames[i]]);
        squares += error_m * error_m;
        errors.largest_m = std::max(errors.largest_m, error_m);
        ++errors.steps;
    }
    if (errors.steps > 0) errors.rmse_m = std::sqrt(squares / static_cast<double>(errors.steps));
    return errors;
}

std::string landmarkErrors(const std::vector<MappedLandmark>& landmarks, const std::string& file,
                           bool haveIds)
{
    const auto truth = readTable(file, haveIds ? 7 : 3);
    std::vector<double> errors_m;
    for (const MappedLandmark& landmark : landmarks)
    {
        const double error_m = distanceToTruth(landmark, truth, haveIds);
        if (std::isfinite(error_m)) errors_m.push_back(error_m);
    }
    if (errors_m.empty()) return "landmarks: none has a truth";
    std::sort(errors_m.begin(), errors_m.end());
    const double sum = std::accumulate(errors_m.begin(), errors_m.end(), 0.0);
    char line[160];
    std::snprintf(
        line, sizeof line,
        "landmarks: %zu mapped, %zu true; error mean %.6f m, median %.6f m, largest %.6f m",
        landmarks.size(), static_cast<std::size_t>(truth.rows()),
        sum / static_cast<double>(errors_m.size()), errors_m[errors_m.size() / 2], errors_m.back());
    return line;
}
}  // namespace monoslam
