// SPDX-License-Identifier: BSD-3-Clause
#include "planarPose.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <sstream>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using Matrix6d = Eigen::Matrix<double, 6, 6>;

Eigen::Vector3d centreOf(const std::vector<Eigen::Vector3d>& points)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

/** Starting poses: both tilts of OpenCV's IPPE on undistorted normalised points. */
std::vector<CameraPose> ippePoses(const SeenPoints& seen, const Camera& camera)
{
    const Eigen::Vector3d centre = centreOf(seen.points_m);
    Eigen::MatrixXd spread(3, seen.points_m.size());
    std::vector<cv::Point2d> rays;
    for (std::size_t i = 0; i < seen.points_m.size(); ++i)
    {
        spread.col(static_cast<Eigen::Index>(i)) = seen.points_m[i] - centre;
        const auto ray = camera.unproject(seen.pixels_px[i]);
        if (!ray) return {};
        rays.emplace_back(ray->x(), ray->y());
    }
    Eigen::Matrix3d R_wp = Eigen::JacobiSVD<Eigen::MatrixXd>(spread, Eigen::ComputeFullU).matrixU();
    if (R_wp.determinant() < 0) R_wp.col(2) *= -1.0;
    std::vector<cv::Point3d> planar;
    for (Eigen::Index i = 0; i < spread.cols(); ++i)
    {
        const Eigen::Vector3d p = R_wp.transpose() * spread.col(i);
        planar.emplace_back(p.x(), p.y(), 0.0);
    }
    std::vector<cv::Mat> rotations;
    std::vector<cv::Mat> translations;
    cv::solvePnPGeneric(planar, rays, cv::Matx33d::eye(), cv::noArray(), rotations, translations,
                        false, cv::SOLVEPNP_IPPE);
    std::vector<CameraPose> poses;
    for (std::size_t i = 0; i < rotations.size(); ++i)
    {
        const Eigen::Vector3d phi(rotations[i].ptr<double>());
        const Eigen::Vector3d t(translations[i].ptr<double>());
        if (!phi.allFinite() || !t.allFinite()) continue;
        const Eigen::Matrix3d R_wc = R_wp * rotationMatrix(quaternionExp(phi)).transpose();
        poses.push_back({R_wc, centre - R_wc * t});
    }
    return poses;
}
/** The same centre with the plane's normal mirrored about the line of sight: the other tilt. */
CameraPose otherTilt(const CameraPose& pose, const SeenPoints& seen)
{
    const Eigen::Vector3d centre = centreOf(seen.points_m);
    const Eigen::Vector3d a = seen.points_m[1] - seen.points_m[0];
    const Eigen::Vector3d n_w = a.cross(seen.points_m[2] - seen.points_m[0]).normalized();
    const Eigen::Vector3d t = pose.R_wc.transpose() * (centre - pose.r_wc);
    const Eigen::Vector3d n_c = pose.R_wc.transpose() * n_w;
    const Eigen::Vector3d sight = t.normalized();
    const Eigen::Vector3d mirrored = 2.0 * n_c.dot(sight) * sight - n_c;
    const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(n_c, mirrored).matrix();
    const Eigen::Matrix3d R_wc = pose.R_wc * turn.transpose();
    return {R_wc, centre - R_wc * t};
}

bool samePose(const CameraPose& a, const CameraPose& b, double distance_m)
{
    const double angle_rad = Eigen::AngleAxisd(a.R_wc.transpose() * b.R_wc).angle();
    return angle_rad < 1e-3 && (a.r_wc - b.r_wc).norm() < 1e-3 * distance_m;
}

/** Covariance of (r, q), and with the points, from the normal equations at a minimum. */
void fillCovariance(const std::vector<PointTerm>& terms, const SeenPoints& seen, MetricPose& out)
{
    const Matrix6d C = informationOf(terms).ldlt().solve(Matrix6d::Identity());
    const Eigen::Vector4d q = out.pose.tail<4>();
    Eigen::Matrix4d QL;
    (void)quaternionProduct(q, q, nullptr, &QL);
    Eigen::Matrix<double, 7, 6> E = Eigen::Matrix<double, 7, 6>::Zero();
    E.topLeftCorner<3, 3>().setIdentity();
    E.bottomRightCorner<4, 3>() = 0.5 * QL.rightCols<3>();
    out.P = E * C * E.transpose();
    out.P = 0.5 * (out.P + out.P.transpose()).eval();
    out.P_pose_points.setZero(7, 3 * static_cast<Eigen::Index>(terms.size()));
    for (std::size_t i = 0; i < terms.size(); ++i)
        out.P_pose_points.middleCols<3>(3 * static_cast<Eigen::Index>(i)) =
            -std::pow(seen.point_sigma_m, 2) * E * C * terms[i].J_uv_pose.transpose() *
            terms[i].weight * terms[i].J_uv_p;
}

PlanarSolution solutionAt(const CameraPose& pose, const std::vector<PointTerm>& terms,
                          const SeenPoints& seen)
{
    PlanarSolution solution;
    MetricPose& out = solution.pose;
    out.pose << pose.r_wc, quaternionFromMatrix(pose.R_wc);
    out.points_m = seen.points_m;
    out.pixels_px = seen.pixels_px;
    out.sigmas_px = seen.sigmas_px;
    fillCovariance(terms, seen, out);
    double sum = 0.0;
    for (const auto& term : terms) sum += term.nu.squaredNorm();
    out.residualRms_px = std::sqrt(sum / (2.0 * static_cast<double>(terms.size())));
    const Eigen::Vector3d sight = pose.r_wc - centreOf(seen.points_m);
    const double variance = sight.dot(out.P.topLeftCorner<3, 3>() * sight);
    out.scaleSigma = std::sqrt(std::max(0.0, variance)) / sight.squaredNorm();
    solution.chi2 = chi2Of(terms);
    return solution;
}
}  // namespace

std::vector<PlanarSolution> solvePlanarPose(const SeenPoints& seen, const Camera& camera)
{
    std::vector<CameraPose> minima;
    std::vector<PlanarSolution> solutions;
    const Eigen::Vector3d centre = centreOf(seen.points_m);
    const auto descend = [&](const CameraPose& start)
    {
        const auto pose = refinePose(seen, camera, start);
        if (!pose) return;
        const double distance_m = (pose->r_wc - centre).norm();
        const auto known = [&](const CameraPose& m) { return samePose(m, *pose, distance_m); };
        if (std::any_of(minima.begin(), minima.end(), known)) return;
        minima.push_back(*pose);
        solutions.push_back(solutionAt(*pose, *pointTerms(seen, camera, *pose), seen));
    };
    for (const auto& start : ippePoses(seen, camera)) descend(start);
    for (const auto& pose : std::vector<CameraPose>(minima)) descend(otherTilt(pose, seen));
    std::sort(solutions.begin(), solutions.end(),
              [](const auto& a, const auto& b) { return a.chi2 < b.chi2; });
    return solutions;
}

MetricStartResult unambiguousPose(const std::vector<PlanarSolution>& solutions)
{
    MetricStartResult result;
    std::ostringstream why;
    if (solutions.empty())
        why << "no camera pose explains the target's corners";
    else if (solutions[0].chi2 > kFittingChi2)
        why << "the corners do not fit the known points: residual "
            << solutions[0].pose.residualRms_px << " px rms";
    else if (solutions.size() > 1 && solutions[1].chi2 < solutions[0].chi2 + kAmbiguousChi2)
        why << "two tilts of the target fit alike: residuals " << solutions[0].pose.residualRms_px
            << " and " << solutions[1].pose.residualRms_px << " px rms; nearer or more oblique "
            << "views tell them apart";
    else
        result.found = solutions[0].pose;
    result.reason = why.str();
    return result;
}
}  // namespace monoslam
