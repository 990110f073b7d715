// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/dataAssociationFullCovariance.h"

#include <stdexcept>
#include <string>

#include "CompatiblePairs.h"

namespace monoslam
{
using mrpt::math::CMatrixDouble;
using mrpt::slam::prediction_index_t;
using mrpt::slam::TDataAssociationMethod;
using mrpt::slam::TDataAssociationMetric;
using mrpt::slam::TDataAssociationResults;

namespace
{
void require(bool condition, const char* what)
{
    if (!condition)
        throw std::invalid_argument(std::string("dataAssociationFullCovariance: ") + what);
}

void checkInput(const CMatrixDouble& Z, const CMatrixDouble& Y, const CMatrixDouble& Y_cov,
                double chi2quantile)
{
    require(Z.rows() > 0 && Z.cols() > 0, "no observations");
    require(Y.rows() > 0, "no predictions");
    require(Z.cols() == Y.cols(), "Z and Y differ in their columns");
    require(Y_cov.rows() == Y.rows() * Y.cols() && Y_cov.rows() == Y_cov.cols(),
            "Y_cov is not NO x NO");
    require(chi2quantile > 0.0 && chi2quantile < 1.0, "chi2quantile is not in (0, 1)");
    require(Z.asEigen().allFinite() && Y.asEigen().allFinite() && Y_cov.asEigen().allFinite(),
            "Z, Y or Y_cov is not finite");
}
}  // namespace

void dataAssociationFullCovariance(const CMatrixDouble& Z, const CMatrixDouble& Y,
                                   const CMatrixDouble& Y_cov, TDataAssociationResults& results,
                                   DataAssociationMethod method, TDataAssociationMetric metric,
                                   double chi2quantile, bool useKdTree,
                                   const std::vector<prediction_index_t>& predictionsIds,
                                   TDataAssociationMetric compatibilityTestMetric,
                                   double logLikelihoodThreshold)
{
    checkInput(Z, Y, Y_cov, chi2quantile);
    require(predictionsIds.empty() || predictionsIds.size() == static_cast<std::size_t>(Y.rows()),
            "predictionsIds are not as many as predictions");
    if (method == assocNN_MRPT || method == assocJCBB_MRPT)
        return mrpt::slam::data_association_full_covariance(
            Z, Y, Y_cov, results,
            method == assocNN_MRPT ? mrpt::slam::assocNN : mrpt::slam::assocJCBB, metric,
            chi2quantile, useKdTree, predictionsIds, compatibilityTestMetric,
            logLikelihoodThreshold);

    const CompatiblePairs pairs(
        static_cast<std::size_t>(Z.rows()), Y_cov.asEigen(),
        [&](std::size_t j, std::size_t i) -> Eigen::VectorXd
        {
            return Z.asEigen().row(static_cast<Eigen::Index>(j)) -
                   Y.asEigen().row(static_cast<Eigen::Index>(i));
        },
        Z.cols(),
        {metric, chi2quantile, compatibilityTestMetric, logLikelihoodThreshold, chi2quantile});
    results = pairs.resultsOf(assign(pairs.problem(), method, kDataAssociationNodes));
    if (predictionsIds.empty()) return;
    for (auto& association : results.associations)
        association.second = predictionsIds[association.second];
}

void dataAssociationFullCovariance(const CMatrixDouble& Z, const CMatrixDouble& Y,
                                   const CMatrixDouble& Y_cov, TDataAssociationResults& results,
                                   TDataAssociationMethod method, TDataAssociationMetric metric,
                                   double chi2quantile, bool useKdTree,
                                   const std::vector<prediction_index_t>& predictionsIds,
                                   TDataAssociationMetric compatibilityTestMetric,
                                   double logLikelihoodThreshold)
{
    dataAssociationFullCovariance(Z, Y, Y_cov, results, static_cast<DataAssociationMethod>(method),
                                  metric, chi2quantile, useKdTree, predictionsIds,
                                  compatibilityTestMetric, logLikelihoodThreshold);
}
}  // namespace monoslam
