// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/slam/data_association.h>

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "monoslam_association/AssignmentProblem.h"
#include "monoslam_mrpt/DataAssociationMethod.h"

namespace monoslam
{
/** The tests of data_association_full_covariance(). */
struct CompatibilityTests
{
    mrpt::slam::TDataAssociationMetric metric = metricMaha;
    double individualQuantile = 0.99;
    mrpt::slam::TDataAssociationMetric individualMetric = metricMaha;
    double logLikelihoodThreshold = 0.0;
    double jointQuantile = 0.99;
};

/** Observations with their individually compatible predictions, and what MRPT reports of them. */
class CompatiblePairs
{
   public:
    using Innovation =
        std::function<Eigen::VectorXd(std::size_t observation, std::size_t prediction)>;

    /** \param S  joint covariance of the innovations, NO x NO; \param innovation  z - y, O numbers */
    CompatiblePairs(std::size_t observations, const Eigen::MatrixXd& S,
                    const Innovation& innovation, Eigen::Index O, const CompatibilityTests& tests);

    /** Takes predictions that are not to be had out of the candidates. */
    void exclude(const std::function<bool(std::size_t prediction)>& taken);

    [[nodiscard]] const AssignmentProblem& problem() const { return problem_; }
    /** Both the individual tests and what was assigned. */
    [[nodiscard]] mrpt::slam::TDataAssociationResults resultsOf(
        const AssignmentResult& result) const;

   private:
    void test(std::size_t observation, std::size_t prediction, const Eigen::VectorXd& nu,
              const CompatibilityTests& tests);

    mrpt::slam::TDataAssociationResults individual_;
    double individualLimit_;
    AssignmentProblem problem_;
};

/** \throw std::invalid_argument for the methods that are not a function of the problem */
[[nodiscard]] AssignmentResult assign(const AssignmentProblem& problem,
                                      DataAssociationMethod method, long nodeCap);
}  // namespace monoslam
