// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace monoslam
{
/** Central differences of fourth order of f at x. */
template <typename Function, typename DerivedX>
Eigen::MatrixXd numericalJacobian(const Function& f, const Eigen::MatrixBase<DerivedX>& x,
                                  double step)
{
    using X = typename DerivedX::PlainObject;
    const auto at = [&](Eigen::Index column, double offset)
    {
        X moved = x;
        moved[column] += offset;
        return Eigen::VectorXd(f(moved));
    };
    Eigen::MatrixXd J(at(0, 0.0).size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
    {
        const Eigen::VectorXd near = at(i, step) - at(i, -step);
        const Eigen::VectorXd far = at(i, 2 * step) - at(i, -2 * step);
        J.col(i) = (8 * near - far) / (12 * step);
    }
    return J;
}

/** Does J equal the numerical Jacobian of f at x, to tolerance (1 + |entry|)? Names the worst
 *  entry if not.
 *  \param f  a function of a vector, callable around x by twice the step */
template <typename Function, typename DerivedX, typename DerivedJ>
::testing::AssertionResult jacobianMatches(const Function& f, const Eigen::MatrixBase<DerivedX>& x,
                                           const Eigen::MatrixBase<DerivedJ>& J,
                                           double tolerance = 1e-7, double step = 1e-4)
{
    const Eigen::MatrixXd numerical = numericalJacobian(f, x, step);
    if (numerical.rows() != J.rows() || numerical.cols() != J.cols())
        return ::testing::AssertionFailure()
               << "the Jacobian is " << J.rows() << " x " << J.cols() << ", should be "
               << numerical.rows() << " x " << numerical.cols();
    if (!J.allFinite()) return ::testing::AssertionFailure() << "not finite:\n" << J;

    const Eigen::ArrayXXd error = (J - numerical).array().abs() / (1 + numerical.array().abs());
    Eigen::Index row = 0, column = 0;
    const double worst = error.maxCoeff(&row, &column);
    if (worst <= tolerance) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "worst entry (" << row << ", " << column << "): analytic " << J(row, column)
           << ", numerical " << numerical(row, column) << ", relative error " << worst;
}
}  // namespace monoslam
