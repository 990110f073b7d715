// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/ConditionalPairs.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace monoslam
{
namespace
{
void checkSizes(const AssignmentProblem& problem)
{
    const Eigen::Index O = problem.dimension, n = problem.HPHt.rows();
    bool good = O > 0 && n == problem.HPHt.cols() && n % O == 0 &&
                problem.limits.size() > problem.items.size();
    for (const auto& item : problem.items)
        for (const AssignmentPair& pair : item)
            good = good && pair.nu.size() == O && pair.block >= 0 && (pair.block + 1) * O <= n &&
                   (pair.R.size() == 0 || (pair.R.rows() == O && pair.R.cols() == O));
    if (!good)
        throw std::invalid_argument("AssignmentProblem: sizes of HPHt, nu, R and limits disagree");
}

template <typename Factor>
double logDetOf(const Factor& llt)
{
    return 2.0 * llt.matrixLLT().diagonal().array().log().sum();
}
}  // namespace

ConditionalPairs::ConditionalPairs(const AssignmentProblem& problem)
    : problem_(problem), O_(problem.dimension)
{
    checkSizes(problem);
    const Eigen::Index n = problem.HPHt.cols();
    const auto capacity = std::min(static_cast<Eigen::Index>(problem.items.size()),
                                   std::max<Eigen::Index>(n / O_, 1));
    W_.resize(capacity * O_, n);
    shift_.resize(capacity + 1, n);
    S_.resize((capacity + 1) * O_, n);
    d2_.assign(static_cast<std::size_t>(capacity) + 1, 0.0);
    logDet_ = d2_;
    shift_.row(0).setZero();
    for (Eigen::Index b = 0; b < n; b += O_)
        S_.block(0, b, O_, O_) = problem.HPHt.block(b, b, O_, O_);
}

template <int O>
ConditionalPairs::Gain ConditionalPairs::gainOf(const AssignmentPair& pair) const
{
    const Eigen::Index b = pair.block * O_;
    Eigen::Matrix<double, O, O> S = S_.block<O, O>(pairs_ * O_, b, O_, O_);
    if (pair.R.size() > 0) S += pair.R;
    Eigen::Matrix<double, O, 1> nu = pair.nu;
    nu -= shift_.row(pairs_).segment<O>(b, O_).transpose();
    const Eigen::LLT<Eigen::Matrix<double, O, O>> llt(S);
    if (llt.info() != Eigen::Success) return {std::numeric_limits<double>::infinity(), 0.0};
    return {nu.dot(llt.solve(nu)), logDetOf(llt)};
}

ConditionalPairs::Gain ConditionalPairs::gain(const AssignmentPair& pair) const
{
    if (O_ == 2) return gainOf<2>(pair);
    if (O_ == 3) return gainOf<3>(pair);
    return gainOf<Eigen::Dynamic>(pair);
}

bool ConditionalPairs::push(const AssignmentPair& pair)
{
    const Eigen::Index b = pair.block * O_, k = pairs_ * O_;
    Eigen::MatrixXd S = S_.block(k, b, O_, O_);
    if (pair.R.size() > 0) S += pair.R;
    const Eigen::LLT<Eigen::MatrixXd> llt(S);
    if (llt.info() != Eigen::Success) return false;

    const Eigen::VectorXd nu = pair.nu - shift_.row(pairs_).segment(b, O_).transpose();
    const Eigen::VectorXd e = llt.matrixL().solve(nu);
    auto W = W_.middleRows(k, O_);
    W = problem_.HPHt.middleRows(b, O_);
    if (k > 0) W.noalias() -= W_.block(0, b, k, O_).transpose() * W_.topRows(k);
    llt.matrixL().solveInPlace(W);
    shift_.row(pairs_ + 1) = shift_.row(pairs_);
    shift_.row(pairs_ + 1).noalias() += e.transpose() * W;
    for (Eigen::Index j = 0; j < problem_.HPHt.cols(); j += O_)
    {
        const auto W_j = W.middleCols(j, O_);
        S_.block(k + O_, j, O_, O_) = S_.block(k, j, O_, O_) - W_j.transpose() * W_j;
    }
    const auto at = static_cast<std::size_t>(pairs_);
    d2_[at + 1] = d2_[at] + e.squaredNorm();
    logDet_[at + 1] = logDet_[at] + logDetOf(llt);
    ++pairs_;
    return true;
}
}  // namespace monoslam
