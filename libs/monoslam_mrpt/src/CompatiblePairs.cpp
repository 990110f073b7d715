// SPDX-License-Identifier: BSD-3-Clause
#include "CompatiblePairs.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "monoslam_association/assignByJcbb.h"
#include "monoslam_association/assignNearest.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/largestCompatibleAssignment.h"

namespace monoslam
{
namespace
{
const double kLogTwoPi = std::log(2.0 * std::acos(-1.0));

/** ln N(nu; 0, S) from the squared distance and ln |S|. */
double logDensity(double d2, double logDet, double numbers)
{
    return -0.5 * (d2 + logDet + numbers * kLogTwoPi);
}
}  // namespace

CompatiblePairs::CompatiblePairs(std::size_t observations, const Eigen::MatrixXd& S,
                                 const Innovation& innovation, Eigen::Index O,
                                 const CompatibilityTests& tests)
    : individualLimit_(chi2Limit(O, tests.individualQuantile))
{
    const Eigen::Index predictions = S.rows() / O;
    problem_.dimension = O;
    problem_.HPHt = S;
    problem_.likelihood = tests.metric == metricML;
    problem_.items.resize(observations);
    for (std::size_t k = 0; k <= observations; ++k)
        problem_.limits.push_back(chi2Limit(O * static_cast<Eigen::Index>(k), tests.jointQuantile));

    const auto columns = static_cast<Eigen::Index>(observations);
    individual_.indiv_distances.setSize(predictions, columns);
    individual_.indiv_compatibility.setSize(predictions, columns);
    individual_.indiv_compatibility_counts.assign(observations, 0);
    for (std::size_t j = 0; j < observations; ++j)
        for (std::size_t i = 0; i < static_cast<std::size_t>(predictions); ++i)
            test(j, i, innovation(j, i), tests);
}

void CompatiblePairs::test(std::size_t observation, std::size_t prediction,
                           const Eigen::VectorXd& nu, const CompatibilityTests& tests)
{
    const auto i = static_cast<Eigen::Index>(prediction), O = problem_.dimension;
    const auto j = static_cast<Eigen::Index>(observation);
    const Eigen::LLT<Eigen::MatrixXd> llt(problem_.HPHt.block(O * i, O * i, O, O));
    double d2 = std::numeric_limits<double>::infinity(), density = -d2;
    if (llt.info() == Eigen::Success)
    {
        d2 = llt.matrixL().solve(nu).squaredNorm();
        const double logDet = 2.0 * llt.matrixLLT().diagonal().array().log().sum();
        density = logDensity(d2, logDet, static_cast<double>(O));
    }
    const bool compatible = tests.individualMetric == metricML
                                ? density > tests.logLikelihoodThreshold
                                : d2 < individualLimit_;
    individual_.indiv_distances(i, j) = tests.metric == metricML ? density : d2;
    individual_.indiv_compatibility(i, j) = compatible;
    if (!compatible) return;
    ++individual_.indiv_compatibility_counts[observation];
    problem_.items[observation].push_back({i, i, nu, {}});
}

void CompatiblePairs::exclude(const std::function<bool(std::size_t prediction)>& taken)
{
    for (auto& item : problem_.items)
        item.erase(std::remove_if(item.begin(), item.end(),
                                  [&](const AssignmentPair& pair)
                                  { return taken(static_cast<std::size_t>(pair.block)); }),
                   item.end());
}

mrpt::slam::TDataAssociationResults CompatiblePairs::resultsOf(const AssignmentResult& result) const
{
    mrpt::slam::TDataAssociationResults results = individual_;
    for (std::size_t j = 0; j < result.chosen.size(); ++j)
        if (result.chosen[j] >= 0)
            results.associations[j] = static_cast<std::size_t>(
                problem_.items[j][static_cast<std::size_t>(result.chosen[j])].block);
    const auto numbers = static_cast<double>(problem_.dimension * result.pairs);
    results.distance =
        problem_.likelihood ? std::exp(logDensity(result.d2, result.logDet, numbers)) : result.d2;
    results.nNodesExploredInJCBB = static_cast<std::size_t>(result.nodes);
    return results;
}

AssignmentResult assign(const AssignmentProblem& problem, DataAssociationMethod method,
                        long nodeCap)
{
    switch (method)
    {
        case assocNN:
            return assignNearest(problem);
        case assocJCBB:
            return assignByJcbb(problem, nodeCap);
        case assocHOHCT:
            return largestCompatibleAssignment(problem, nodeCap);
        case assocMHDA:
            throw std::invalid_argument(
                "data association MHDA carries several filters: use RangeBearingMhda");
        case assocNN_MRPT:
        case assocJCBB_MRPT:
            break;
    }
    throw std::invalid_argument("data association: unknown method " +
                                std::to_string(static_cast<int>(method)));
}
}  // namespace monoslam
