// SPDX-License-Identifier: BSD-3-Clause
// The two uses of the Schur complement that eliminates the landmarks: a step and the covariance.
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "WindowEquations.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using Factor = Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower>;

bool isDetermined(const Factor& ldlt)
{
    return ldlt.info() == Eigen::Success && ldlt.isPositive() && ldlt.vectorD().allFinite();
}

Vector7d movePose(const Vector7d& pose, const Eigen::Matrix<double, 6, 1>& d)
{
    Vector7d moved;
    moved.head<3>() = pose.head<3>() + d.head<3>();
    moved.tail<4>() =
        normalizeQuaternion(quaternionProduct(pose.tail<4>(), quaternionExp(d.tail<3>())));
    return moved;
}

}  // namespace

Eigen::MatrixXd WindowEquations::reduced(double lambda, std::vector<Eigen::Matrix3d>& inverse) const
{
    Eigen::MatrixXd S = H_pp_;
    S.diagonal() *= 1.0 + lambda;
    inverse.resize(H_ll_.size());
    Eigen::MatrixXd A(H_pl_.rows(), H_pl_.cols());
    for (std::size_t i = 0; i < H_ll_.size(); ++i)
    {
        const Eigen::Index column = 3 * static_cast<Eigen::Index>(i);
        Eigen::Matrix3d damped = H_ll_[i];
        damped.diagonal() *= 1.0 + lambda;
        inverse[i] = damped.inverse();
        const Eigen::Matrix3d L = Eigen::LLT<Eigen::Matrix3d>(inverse[i]).matrixL();
        A.middleCols<3>(column).noalias() = H_pl_.middleCols<3>(column) * L;
    }
    S.selfadjointView<Eigen::Lower>().rankUpdate(A, -1.0);
    return S;
}

Window WindowEquations::step(const Window& at, double lambda) const
{
    std::vector<Eigen::Matrix3d> inverse;
    const Eigen::MatrixXd S = reduced(lambda, inverse);
    Eigen::VectorXd b = b_p_;
    for (std::size_t i = 0; i < inverse.size(); ++i)
        b.noalias() -=
            H_pl_.middleCols<3>(3 * static_cast<Eigen::Index>(i)) * (inverse[i] * b_l_[i]);
    const Factor ldlt(S);
    const Eigen::VectorXd d = ldlt.solve(b);
    Window moved = at;
    for (std::size_t k = 0; k < moved.poses.size(); ++k)
        moved.poses[k] =
            movePose(moved.poses[k], d.segment<kPoseDof>(kPoseDof * static_cast<Eigen::Index>(k)));
    for (std::size_t i = 0; i < moved.landmarks.size(); ++i)
    {
        const Eigen::Index column = 3 * static_cast<Eigen::Index>(i);
        const Eigen::Vector3d dl =
            inverse[i] * (b_l_[i] - H_pl_.middleCols<3>(column).transpose() * d);
        WindowLandmark& landmark = moved.landmarks[i];
        landmark.y.segment<3>(freeOffset(landmark.kind)) += dl;
    }
    return moved;
}

bool WindowEquations::determined() const
{
    std::vector<Eigen::Matrix3d> inverse;
    return isDetermined(Factor(reduced(0.0, inverse)));
}

Eigen::MatrixXd WindowEquations::covariance() const
{
    const auto n = static_cast<Eigen::Index>(H_ll_.size());
    constexpr Eigen::Index kPoses = 3 * kPoseDof;
    std::vector<Eigen::Matrix3d> inverse;
    const Factor ldlt(reduced(0.0, inverse));
    if (!isDetermined(ldlt)) return {};
    const Eigen::MatrixXd cov = ldlt.solve(Eigen::MatrixXd::Identity(poseSize_, poseSize_));
    Eigen::MatrixXd G(3 * n, poseSize_);
    Eigen::MatrixXd P = Eigen::MatrixXd::Zero(kPoses + 3 * n, kPoses + 3 * n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        const Eigen::Matrix3d& H_ii_inverse = inverse[static_cast<std::size_t>(i)];
        G.middleRows<3>(3 * i).noalias() = H_ii_inverse * H_pl_.middleCols<3>(3 * i).transpose();
        P.block<3, 3>(kPoses + 3 * i, kPoses + 3 * i) = H_ii_inverse;
    }
    const Eigen::MatrixXd Gc = G * cov;
    P.bottomRightCorner(3 * n, 3 * n).noalias() += Gc * G.transpose();
    constexpr Eigen::Index kLastTwo = 2 * kPoseDof;
    P.topLeftCorner<kPoseDof, kPoseDof>() = cov.topLeftCorner<kPoseDof, kPoseDof>();
    P.block<kPoseDof, kLastTwo>(0, kPoseDof) = cov.topRightCorner<kPoseDof, kLastTwo>();
    P.block<kLastTwo, kPoseDof>(kPoseDof, 0) = cov.bottomLeftCorner<kLastTwo, kPoseDof>();
    P.block<kLastTwo, kLastTwo>(kPoseDof, kPoseDof) = cov.bottomRightCorner<kLastTwo, kLastTwo>();
    P.bottomLeftCorner(3 * n, kPoseDof) = -Gc.leftCols<kPoseDof>();
    P.block(kPoses, kPoseDof, 3 * n, kLastTwo) = -Gc.rightCols<kLastTwo>();
    P.topRightCorner(kPoses, 3 * n) = P.bottomLeftCorner(3 * n, kPoses).transpose();
    return 0.5 * (P + P.transpose());
}
}  // namespace monoslam
