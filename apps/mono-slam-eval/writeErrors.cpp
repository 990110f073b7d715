// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>

#include "Figure.h"
#include "monoslam_slam/writers.h"
#include "monoslam_support/csvCells.h"

namespace monoslam
{
namespace
{
std::string cell(double value)
{
    return "," + number(value);
}

std::string cells(const Eigen::Vector3d& p)
{
    return cell(p.x()) + cell(p.y()) + cell(p.z());
}

/** Angle of the rotation whose vector part is half of the error's. */
double angle_rad(const Vector6d& error)
{
    return 2.0 * std::asin(std::min(1.0, 0.5 * error.tail<3>().norm()));
}
}  // namespace

void writeErrors(const RunOutput& run, const std::vector<PosePair>& pairs, Alignment alignment)
{
    const Similarity fit = align(pairs, alignment);
    const Similarity own = alignment == Alignment::None ? fit : alignFirstPose(pairs, alignment);
    const auto consistency = trajectoryNees(pairs, run.covariances, own);
    std::ostringstream lines;
    lines
        << "t_s,position_error_m,rotation_error_rad,nees,x_m,y_m,z_m,true_x_m,true_y_m,true_z_m\n";
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const StampedPose pose = transform(fit, pairs[i].estimate);
        const Vector6d error = poseError(pose, pairs[i].truth);
        lines << number(pose.t_s, "%.7f") << cell(error.head<3>().norm()) << cell(angle_rad(error))
              << (consistency[i] ? cell(*consistency[i]) : ",") << cells(pose.r_wc)
              << cells(pairs[i].truth.r_wc) << '\n';
    }
    OutputFile(run.folder + "/errors.csv").write(lines.str());
}
}  // namespace monoslam
