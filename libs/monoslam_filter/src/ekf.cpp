// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/ekf.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using camera_state::kOrientation;
using camera_state::kSize;

constexpr double kInflation = 1.1;

void mirrorLowerHalf(Eigen::MatrixXd& P)
{
    P.triangularView<Eigen::StrictlyUpper>() = P.transpose();
}

void normalizeAt(Belief& belief, Eigen::Index offset)
{
    Eigen::Matrix4d J_n_q;
    belief.x.segment<4>(offset) = normalizeQuaternion(belief.x.segment<4>(offset), &J_n_q);
    const Eigen::Matrix<double, Eigen::Dynamic, 4> columns = belief.P.middleCols<4>(offset);
    belief.P.middleCols<4>(offset).noalias() = columns * J_n_q.transpose();
    const Eigen::Matrix<double, 4, Eigen::Dynamic> rows = belief.P.middleRows<4>(offset);
    belief.P.middleRows<4>(offset).noalias() = J_n_q * rows;
}

/** Of a mean alone. \param layout  whose clones it has */
void normalizeMean(Eigen::VectorXd& x, const Belief& layout)
{
    x.segment<4>(kOrientation) = normalizeQuaternion(x.segment<4>(kOrientation));
    for (const auto& slot : layout.clones)
        x.segment<4>(slot.offset + kOrientation) =
            normalizeQuaternion(x.segment<4>(slot.offset + kOrientation));
}

Eigen::LLT<Eigen::MatrixXd> factorize(JointInnovation& joint,
                                      const std::vector<PixelMeasurement>& pixels, int* faults)
{
    Eigen::LLT<Eigen::MatrixXd> llt(joint.S);
    if (llt.info() == Eigen::Success) return llt;
    if (faults) ++*faults;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        joint.S.block<2, 2>(2 * static_cast<Eigen::Index>(i), 2 * static_cast<Eigen::Index>(i)) +=
            (kInflation - 1.0) * pixels[i].R;
    llt.compute(joint.S);
    if (llt.info() != Eigen::Success)
        throw std::runtime_error("ekfUpdate: the innovation covariance is not positive definite");
    return llt;
}

Eigen::MatrixXd stackPHt(const Prediction& prediction, const std::vector<PixelMeasurement>& pixels)
{
    Eigen::MatrixXd PHt(prediction.PHt.rows(), 2 * static_cast<Eigen::Index>(pixels.size()));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        PHt.middleCols<2>(2 * static_cast<Eigen::Index>(i)) =
            prediction.PHt.middleCols<2>(2 * pixels[i].row);
    return PHt;
}
}  // namespace

void normalizeQuaternions(Belief& belief)
{
    normalizeAt(belief, kOrientation);
    for (const auto& slot : belief.clones) normalizeAt(belief, slot.offset + kOrientation);
}

Belief ekfPredict(Belief belief, const ConstantVelocityOptions& motion, double dt_s)
{
    if (!(dt_s >= 0.0) || !std::isfinite(dt_s))
        throw std::invalid_argument("ekfPredict: the time step is negative or not finite");
    const MotionPrediction step = predictConstantVelocity(belief.camera(), dt_s, motion);
    Eigen::Matrix4d J_n_q;
    Matrix13d F = step.F;
    belief.x.head<kSize>() = step.x_v;
    belief.x.segment<4>(kOrientation) =
        normalizeQuaternion(belief.x.segment<4>(kOrientation), &J_n_q);
    F.middleRows<4>(kOrientation) = J_n_q * F.middleRows<4>(kOrientation).eval();
    Matrix13d Q = step.Q;
    Q.middleRows<4>(kOrientation) = J_n_q * Q.middleRows<4>(kOrientation).eval();
    Q.middleCols<4>(kOrientation) = Q.middleCols<4>(kOrientation).eval() * J_n_q.transpose();

    const Eigen::Index rest = belief.size() - kSize;
    const Matrix13d P_vv = belief.P.topLeftCorner<kSize, kSize>();
    const Matrix13d FP = F * P_vv;
    const Matrix13d P_new = FP * F.transpose() + Q;
    belief.P.topLeftCorner<kSize, kSize>() = 0.5 * (P_new + P_new.transpose());
    const Eigen::Matrix<double, Eigen::Dynamic, kSize> P_mv =
        belief.P.bottomLeftCorner(rest, kSize);
    belief.P.bottomLeftCorner(rest, kSize).noalias() = P_mv * F.transpose();
    belief.P.topRightCorner(kSize, rest) = belief.P.bottomLeftCorner(rest, kSize).transpose();
    return belief;
}

JointInnovation stackInnovation(const Prediction& prediction,
                                const std::vector<PixelMeasurement>& pixels)
{
    const auto m = static_cast<Eigen::Index>(pixels.size());
    JointInnovation joint{Eigen::VectorXd(2 * m), Eigen::MatrixXd(2 * m, 2 * m)};
    for (Eigen::Index i = 0; i < m; ++i)
    {
        const PixelMeasurement& pixel = pixels[static_cast<std::size_t>(i)];
        joint.nu.segment<2>(2 * i) =
            pixel.z - prediction.rows[static_cast<std::size_t>(pixel.row)].h;
        for (Eigen::Index j = 0; j <= i; ++j)
        {
            const Eigen::Index other = pixels[static_cast<std::size_t>(j)].row;
            Eigen::Matrix2d block =
                0.5 * (prediction.HPHt.block<2, 2>(2 * pixel.row, 2 * other) +
                       prediction.HPHt.block<2, 2>(2 * other, 2 * pixel.row).transpose());
            if (i == j) block += pixel.R;
            joint.S.block<2, 2>(2 * i, 2 * j) = block;
            joint.S.block<2, 2>(2 * j, 2 * i) = block.transpose();
        }
    }
    return joint;
}

EkfCorrection ekfCorrection(const Belief& prior, const Prediction& prediction,
                            const std::vector<PixelMeasurement>& pixels, int* faults)
{
    EkfCorrection correction{prior.x, {}, prior.x};
    if (pixels.empty()) return correction;
    JointInnovation joint = stackInnovation(prediction, pixels);
    const auto llt = factorize(joint, pixels, faults);
    correction.W = stackPHt(prediction, pixels);
    llt.matrixU().solveInPlace<Eigen::OnTheRight>(correction.W);
    const Eigen::VectorXd whitened = llt.matrixL().solve(joint.nu);
    correction.raw.noalias() += correction.W * whitened;
    correction.x = correction.raw;
    normalizeMean(correction.x, prior);
    return correction;
}

Belief applyCorrection(Belief prior, const EkfCorrection& correction)
{
    if (correction.W.size() == 0) return prior;
    prior.x = correction.raw;
    prior.P.selfadjointView<Eigen::Lower>().rankUpdate(correction.W, -1.0);
    mirrorLowerHalf(prior.P);
    normalizeQuaternions(prior);
    return prior;
}

Belief ekfUpdate(Belief prior, const Prediction& prediction,
                 const std::vector<PixelMeasurement>& pixels, int* faults)
{
    const EkfCorrection correction = ekfCorrection(prior, prediction, pixels, faults);
    return applyCorrection(std::move(prior), correction);
}

Eigen::VectorXd ekfUpdateMean(const Belief& prior, const Prediction& prediction,
                              const std::vector<PixelMeasurement>& pixels)
{
    Eigen::VectorXd x = prior.x;
    if (pixels.empty()) return x;
    JointInnovation joint = stackInnovation(prediction, pixels);
    const auto llt = factorize(joint, pixels, nullptr);
    const Eigen::VectorXd weights = llt.solve(joint.nu);
    x.noalias() += stackPHt(prediction, pixels) * weights;
    normalizeMean(x, prior);
    return x;
}
}  // namespace monoslam
