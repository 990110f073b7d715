// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/CMatrixFixed.h>

#include <sstream>

/** MRPT's library holds these members of fixed matrices for a few sizes only; a Kalman filter
 *  whose vehicle has 13 numbers does not link without them. */
namespace mrpt::math
{
// NOLINTBEGIN(readability-identifier-naming): the names are MRPT's
template <>
inline std::string MatrixVectorBase<double, CMatrixFixed<double, 13, 13>>::asString() const
{
    std::ostringstream out;
    out << mvbDerived().asEigen();
    return out.str();
}

template <>
inline CMatrixFixed<double, 13, 13>
MatrixVectorBase<double, CMatrixFixed<double, 13, 13>>::impl_op_subs(
    const CMatrixFixed<double, 13, 13>& other) const
{
    CMatrixFixed<double, 13, 13> difference;
    difference.asEigen() = mvbDerived().asEigen() - other.asEigen();
    return difference;
}

template <>
inline double MatrixVectorBase<double, CMatrixFixed<double, 13, 13>>::sum_abs() const
{
    return mvbDerived().asEigen().cwiseAbs().sum();
}
// NOLINTEND(readability-identifier-naming)
}  // namespace mrpt::math
