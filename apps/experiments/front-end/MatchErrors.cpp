// SPDX-License-Identifier: BSD-3-Clause
#include "MatchErrors.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace monoslam
{
namespace
{
double median(std::vector<double> values)
{
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/** Rms of the components about the mean of their own landmark, with one freedom less for each. */
double sigmaWithinTracks(const std::vector<MatchError>& errors)
{
    struct Track
    {
        long count = 0;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        double squares = 0.0;
    };
    std::map<LandmarkId, Track> tracks;
    for (const MatchError& error : errors)
    {
        Track& track = tracks[error.id];
        ++track.count;
        track.sum += error.e_px;
        track.squares += error.e_px.squaredNorm();
    }
    double squares = 0.0;
    long freedom = 0;
    for (const auto& [id, track] : tracks)
    {
        squares += track.squares - track.sum.squaredNorm() / static_cast<double>(track.count);
        freedom += 2 * (track.count - 1);
    }
    return freedom > 0 ? std::sqrt(std::max(squares, 0.0) / static_cast<double>(freedom)) : 0.0;
}
}  // namespace

ErrorFigures figuresOf(const std::vector<MatchError>& all)
{
    ErrorFigures figures;
    figures.count = static_cast<long>(all.size());
    std::vector<MatchError> errors;
    for (const MatchError& error : all)
        if (error.e_px.norm() <= kWrong_px) errors.push_back(error);
    figures.wrong = static_cast<long>(all.size() - errors.size());
    if (errors.empty()) return figures;
    const auto n = static_cast<double>(errors.size());
    std::vector<double> sizes;
    std::vector<double> nis;
    for (const MatchError& error : errors)
    {
        figures.bias_px += error.e_px / n;
        nis.push_back(error.e_px.dot(error.R.inverse() * error.e_px));
        figures.nis += nis.back() / n;
        sizes.push_back(std::abs(error.e_px.x()));
        sizes.push_back(std::abs(error.e_px.y()));
    }
    Eigen::Vector2d squares = Eigen::Vector2d::Zero();
    for (const MatchError& error : errors) squares += (error.e_px - figures.bias_px).cwiseAbs2();
    figures.sigma_px = (squares / n).cwiseSqrt();
    figures.trackSigma_px = sigmaWithinTracks(errors);
    figures.medianAbs_px = median(sizes);
    figures.medianNis = median(nis);
    return figures;
}

std::string tableHead()
{
    return "| matches | n | beyond 3 px | bias u | bias v | std u | std v | std within tracks | "
           "median \\|e\\| | mean NIS | median NIS |\n"
           "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
}

std::string tableLine(const std::string& name, const ErrorFigures& f)
{
    char line[300];
    std::snprintf(line, sizeof line,
                  "| %s | %ld | %ld | %+.3f | %+.3f | %.3f | %.3f | %.3f | %.3f | %.2f | %.2f |\n",
                  name.c_str(), f.count, f.wrong, f.bias_px.x(), f.bias_px.y(), f.sigma_px.x(),
                  f.sigma_px.y(), f.trackSigma_px, f.medianAbs_px, f.nis, f.medianNis);
    return line;
}
}  // namespace monoslam
