// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_mrpt/DataAssociationMethod.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** Nodes after which a joint search ends with the best assignment so far. */
inline constexpr long kDataAssociationNodes = 20000;

/** mrpt::slam::data_association_full_covariance() with the joint test that it lacks.
 *
 * Same arguments, same result. Every method starts from the individual test of each observation
 * with each prediction; JCBB and HOHCT accept only assignments whose joint D2 is within
 * chi2(O pairs, chi2quantile). With metricML the best of equally large assignments is the most
 * likely one, and distance is its density; else it is the joint D2, for nearest neighbours too.
 * nNodesExploredInJCBB counts for both; from kDataAssociationNodes on the answer is not proved.
 * \param Z  M x O, observations; \param Y  N x O, predictions
 * \param Y_cov  NO x NO, joint covariance of z - y, thus H P H' + R
 * \param useKdTree  changes nothing: MRPT's loses compatible pairs by it
 * \param predictionsIds  N names to use instead of the rows of Y, or none
 * \throw std::invalid_argument on sizes that disagree, nothing to associate, a quantile outside
 *        (0, 1), numbers that are none, and assocMHDA, which needs several filters */
MONOSLAM_MRPT_EXPORT void dataAssociationFullCovariance(
    const mrpt::math::CMatrixDouble& Z, const mrpt::math::CMatrixDouble& Y,
    const mrpt::math::CMatrixDouble& Y_cov, mrpt::slam::TDataAssociationResults& results,
    DataAssociationMethod method = assocJCBB,
    mrpt::slam::TDataAssociationMetric metric = metricMaha, double chi2quantile = 0.99,
    bool useKdTree = true, const std::vector<mrpt::slam::prediction_index_t>& predictionsIds = {},
    mrpt::slam::TDataAssociationMetric compatibilityTestMetric = metricMaha,
    double logLikelihoodThreshold = 0.0);

/** The same for callers that name the method by MRPT's enumeration: ours of that name. */
MONOSLAM_MRPT_EXPORT void dataAssociationFullCovariance(
    const mrpt::math::CMatrixDouble& Z, const mrpt::math::CMatrixDouble& Y,
    const mrpt::math::CMatrixDouble& Y_cov, mrpt::slam::TDataAssociationResults& results,
    mrpt::slam::TDataAssociationMethod method,
    mrpt::slam::TDataAssociationMetric metric = metricMaha, double chi2quantile = 0.99,
    bool useKdTree = true, const std::vector<mrpt::slam::prediction_index_t>& predictionsIds = {},
    mrpt::slam::TDataAssociationMetric compatibilityTestMetric = metricMaha,
    double logLikelihoodThreshold = 0.0);
}  // namespace monoslam
