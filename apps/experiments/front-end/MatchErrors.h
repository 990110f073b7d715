// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "monoslam_filter/Belief.h"

namespace monoslam
{
/** One match against the truth. */
struct MatchError
{
    LandmarkId id = -1;
    long age = 0;                ///< frames since birth
    double scale = 1.0;          ///< size now over size at birth
    double viewAngle_deg = 0.0;  ///< between the directions of view, then and now
    Eigen::Vector2d e_px = Eigen::Vector2d::Zero();  ///< z - true pixel
    Eigen::Matrix2d R = Eigen::Matrix2d::Identity();
    double patchVariation = 0.0;  ///< of the depth in the birth patch
    double patchBend = 0.0;       ///< of it, off one plane
    bool hidden = false;          ///< something stands before the point
};

/** One line of the table. */
struct ErrorFigures
{
    long count = 0;
    long wrong = 0;  ///< beyond kWrong_px, left out of the rest
    Eigen::Vector2d bias_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d sigma_px = Eigen::Vector2d::Zero();
    double trackSigma_px = 0.0;  ///< rms over u and v of the errors about the mean of each track
    double medianAbs_px = 0.0;   ///< of the error's components
    double nis = 0.0;            ///< mean of e' R^-1 e, 2 when R is right
    double medianNis = 0.0;      ///< 1.39 when R is right
};

inline constexpr double kWrong_px = 3.0;

[[nodiscard]] ErrorFigures figuresOf(const std::vector<MatchError>& errors);

/** Columns and one line of a Markdown table. */
[[nodiscard]] std::string tableHead();
[[nodiscard]] std::string tableLine(const std::string& name, const ErrorFigures& figures);
}  // namespace monoslam
