// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "monoslam_models/InverseDepth.h"
#include "monoslam_slam/writers.h"
#include "monoslam_support/csvCells.h"

namespace monoslam
{
namespace
{
/** `count` numbers of a triangle's or a vector's entries, empty where there are none. */
std::string fields(const std::vector<double>& values, std::size_t count)
{
    std::string line;
    for (std::size_t i = 0; i < count; ++i)
        line += "," + (i < values.size() ? number(values[i]) : std::string());
    return line;
}

std::vector<double> upperTriangle(const Eigen::MatrixXd& P)
{
    std::vector<double> values;
    for (Eigen::Index i = 0; i < P.rows(); ++i)
        for (Eigen::Index j = i; j < P.cols(); ++j) values.push_back(P(i, j));
    return values;
}

std::string mapHeader()
{
    std::string header =
        "id,kind,known,times_seen,last_seen,born_frame,born_u_px,born_v_px,x_m,y_m,z_m,x0_m,y0_m,"
        "z0_m,theta_rad,phi_rad,rho_1pm";
    const char* point[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) header += std::string(",P_") + point[i] + "_" + point[j];
    const char* ray[] = {"x0", "y0", "z0", "theta", "phi", "rho"};
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) header += std::string(",P_") + ray[i] + "_" + ray[j];
    return header + "\n";
}

std::string mapLine(const MapLandmark& landmark)
{
    const auto point = pointOf(landmark);
    const bool isRay = landmark.kind == LandmarkKind::InverseDepth;
    std::vector<double> p, P, y, P_y;
    if (point) p.assign(point->p.data(), point->p.data() + 3), P = upperTriangle(point->P);
    if (isRay)
        y.assign(landmark.y.data(), landmark.y.data() + 6), P_y = upperTriangle(landmark.P_y);
    return std::to_string(landmark.id) + (isRay ? ",inverse_depth," : ",point,") +
           (landmark.known ? "1," : "0,") + std::to_string(landmark.timesSeen) + "," +
           std::to_string(landmark.lastSeen) + "," + std::to_string(landmark.bornFrame) +
           fields({landmark.born_px.x(), landmark.born_px.y()}, 2) + fields(p, 3) + fields(y, 6) +
           fields(P, 6) + fields(P_y, 21) + "\n";
}
}  // namespace

std::optional<LandmarkPoint> pointOf(const MapLandmark& landmark)
{
    LandmarkPoint point;
    if (landmark.kind != LandmarkKind::InverseDepth)
    {
        point.p = landmark.y;
        point.P = landmark.P_y;
        return point;
    }
    const Vector6d y = landmark.y;
    const double rho = y[inverse_depth::kRho];
    const double sigma = std::sqrt(landmark.P_y(inverse_depth::kRho, inverse_depth::kRho));
    if (!(rho > 0 && rho - 2 * sigma > 0)) return std::nullopt;
    Matrix36d J_p_y;
    point.p = toPoint(y, &J_p_y);
    point.P = J_p_y * landmark.P_y * J_p_y.transpose();
    return point;
}

void writeMapCsv(const std::string& folder, const std::vector<MapLandmark>& map)
{
    OutputFile file(folder + "/map.csv");
    std::string lines = mapHeader();
    for (const auto& landmark : map) lines += mapLine(landmark);
    file.write(lines);
}

void writeMapPly(const std::string& folder, const std::vector<MapLandmark>& map)
{
    std::string lines;
    int count = 0;
    for (const auto& landmark : map)
    {
        const auto point = pointOf(landmark);
        if (!point) continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(point->P);
        const double sigma = std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
        for (const double value : point->p) lines += number(value) + " ";
        lines += number(sigma) + " " + std::to_string(landmark.id) + "\n";
        ++count;
    }
    OutputFile file(folder + "/map.ply");
    file.write("ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
               "\nproperty double x\nproperty double y\nproperty double z\n"
               "property double sigma_max\nproperty int id\nend_header\n" +
               lines);
}
}  // namespace monoslam
