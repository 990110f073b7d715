// SPDX-License-Identifier: BSD-3-Clause
// A caller of data association, to be included once for MRPT's and once for ours:
// ASSOCIATION_NAMESPACE and FULL_COVARIANCE say whose, FULL_COVARIANCE_CALLER where the caller goes.
#include <mrpt/slam/data_association.h>

#include <vector>

#include "monoslam_mrpt/dataAssociationFullCovariance.h"

namespace FULL_COVARIANCE_CALLER
{
using namespace ASSOCIATION_NAMESPACE;  // NOLINT(google-global-names-in-headers): compiled twice

inline std::vector<mrpt::slam::TDataAssociationResults> callInEveryWay(
    const mrpt::math::CMatrixDouble& Z, const mrpt::math::CMatrixDouble& Y,
    const mrpt::math::CMatrixDouble& S)
{
    const std::vector<mrpt::slam::prediction_index_t> names(static_cast<std::size_t>(Y.rows()), 7);
    std::vector<mrpt::slam::TDataAssociationResults> results(8);
    FULL_COVARIANCE(Z, Y, S, results[0]);
    FULL_COVARIANCE(Z, Y, S, results[1], assocNN);
    FULL_COVARIANCE(Z, Y, S, results[2], assocJCBB, metricMaha);
    FULL_COVARIANCE(Z, Y, S, results[3], assocNN, metricML, 0.95);
    FULL_COVARIANCE(Z, Y, S, results[4], mrpt::slam::assocNN, mrpt::slam::metricMaha, 0.9, false);
    FULL_COVARIANCE(Z, Y, S, results[5], assocJCBB, metricMaha, 0.99, true, names);
    FULL_COVARIANCE(Z, Y, S, results[6], assocNN, metricMaha, 0.99, true, names, metricML);
    FULL_COVARIANCE(Z, Y, S, results[7], assocNN, metricML, 0.99, false, {}, metricML, -9.0);
    return results;
}
}  // namespace FULL_COVARIANCE_CALLER
