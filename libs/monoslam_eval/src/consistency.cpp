// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/consistency.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kSameTime_s = 1e-4;

/** d dtheta / dq of dtheta = 2 vec(q* x q_est) at q_est = q: 3 x 4. */
Matrix34d angleFromQuaternion(const Eigen::Vector4d& q)
{
    Eigen::Matrix4d J_qp_p;
    const Eigen::Vector4d one = Eigen::Vector4d::Unit(0);
    (void)quaternionProduct(quaternionConjugate(q), one, nullptr, &J_qp_p);
    return 2.0 * J_qp_p.bottomRows<3>();
}

bool parseCovariance(std::string line, StampedCovariance& row)
{
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    if (!(in >> row.t_s)) return false;
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j)
        {
            if (!(in >> row.P(i, j))) return false;
            row.P(j, i) = row.P(i, j);
        }
    std::string rest;
    return !(in >> rest) && row.P.allFinite();
}

/** P of (s R dr, dtheta): the rotation error is in the camera frame and stays. */
Matrix6d transformCovariance(const Similarity& similarity, const Matrix6d& P)
{
    Matrix6d J = Matrix6d::Identity();
    J.topLeftCorner<3, 3>() = similarity.s * similarity.R;
    return J * P * J.transpose();
}
}  // namespace

Vector6d poseError(const StampedPose& estimate, const StampedPose& truth)
{
    Eigen::Vector4d q = quaternionProduct(quaternionConjugate(truth.q_wc), estimate.q_wc);
    if (q[0] < 0.0) q = -q;
    Vector6d e;
    e << estimate.r_wc - truth.r_wc, 2.0 * q.tail<3>();
    return e;
}

std::optional<double> nees(const Vector6d& e, const Matrix6d& P)
{
    const Vector6d scale = P.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return {};
    const Matrix6d correlation = scale.asDiagonal() * P * scale.asDiagonal();
    const Eigen::LLT<Matrix6d> llt(correlation);
    if (llt.info() != Eigen::Success) return {};
    const Vector6d normalized = scale.cwiseProduct(e);
    return normalized.dot(llt.solve(normalized));
}

Matrix6d poseErrorCovariance(const Vector7d& pose, const Eigen::MatrixXd& P)
{
    Eigen::Matrix<double, 6, 7> T = Eigen::Matrix<double, 6, 7>::Zero();
    T.topLeftCorner<3, 3>().setIdentity();
    T.bottomRightCorner<3, 4>() = angleFromQuaternion(pose.segment<4>(camera_state::kOrientation));
    constexpr Eigen::Index n = camera_state::kPoseSize;
    return T * P.topLeftCorner<n, n>() * T.transpose();
}

Interval chi2MeanBounds(int dof, int runs, double probability)
{
    const boost::math::chi_squared distribution(static_cast<double>(dof) * runs);
    const double tail = 0.5 * (1.0 - probability);
    return {boost::math::quantile(distribution, tail) / runs,
            boost::math::quantile(boost::math::complement(distribution, tail)) / runs};
}

std::vector<StampedCovariance> readCovariances(const std::string& fileName)
{
    std::ifstream file(fileName);
    if (!file) throw std::invalid_argument(fileName + ": cannot be read");
    std::vector<StampedCovariance> rows;
    std::string line;
    for (long number = 1; std::getline(file, line); ++number)
    {
        const bool header = number == 1 && line.find("t_s") != std::string::npos;
        if (line.empty() || line[0] == '#' || header) continue;
        StampedCovariance row;
        if (!parseCovariance(line, row))
            throw std::invalid_argument(fileName + ":" + std::to_string(number) +
                                        ": not a time and 21 finite numbers");
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::optional<double>> trajectoryNees(const std::vector<PosePair>& pairs,
                                                  const std::vector<StampedCovariance>& covariances,
                                                  const Similarity& alignment)
{
    std::vector<std::optional<double>> values;
    auto row = covariances.begin();
    for (const PosePair& pair : pairs)
    {
        std::optional<double>& value = values.emplace_back();
        while (row != covariances.end() && row->t_s < pair.estimate.t_s - kSameTime_s) ++row;
        if (row == covariances.end() || row->t_s > pair.estimate.t_s + kSameTime_s) continue;
        const Vector6d e = poseError(transform(alignment, pair.estimate), pair.truth);
        value = nees(e, transformCovariance(alignment, row->P));
    }
    return values;
}
}  // namespace monoslam
