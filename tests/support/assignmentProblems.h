// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "monoslam_association/AssignmentProblem.h"
#include "subsetProblems.h"

namespace monoslam::test
{
struct AssignmentShape
{
    Eigen::Index dimension = 2;
    Eigen::Index predictions = 5;
    int items = 4;
    int wrong = 1;          ///< items that are nobody's
    double gate = 0.95;     ///< of the individual test that makes candidates
    bool ownNoise = false;  ///< R with each pair; else in HPHt, as MRPT has it
};

/** Predictions that share a pose error of many sigma of the noise; items drawn about the first of
 *  them, as the joint covariance says, in random order, the wrong ones displaced within the gate. */
inline AssignmentProblem randomAssignment(const AssignmentShape& shape, std::mt19937& rng)
{
    if (shape.wrong > shape.items || shape.items > shape.predictions)
        throw std::invalid_argument(
            "randomAssignment: an item without a prediction to be drawn about");
    const Eigen::Index O = shape.dimension, n = O * shape.predictions;
    const Eigen::MatrixXd J = 4.0 * gaussian(n, 3, rng);
    const Eigen::VectorXd h = 9.0 * gaussian(n, 1, rng);
    const Eigen::MatrixXd noise = Eigen::MatrixXd::Identity(n, n);
    AssignmentProblem problem;
    problem.dimension = O;
    problem.HPHt = J * J.transpose();
    const Eigen::MatrixXd S = problem.HPHt + noise;
    Eigen::VectorXd z = h + Eigen::VectorXd(S.llt().matrixL() * gaussian(n, 1, rng));
    std::uniform_real_distribution<double> uniform(-2.0, 2.0);
    for (Eigen::Index i = 0; i < O * shape.wrong; ++i)
        z(i) = h(i) + uniform(rng) * std::sqrt(S(i, i));
    if (!shape.ownNoise) problem.HPHt = S;

    std::vector<Eigen::Index> order(static_cast<std::size_t>(shape.items));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::shuffle(order.begin(), order.end(), rng);
    const double limit = chi2Limit(O, shape.gate);
    for (const Eigen::Index j : order)
    {
        problem.items.emplace_back();
        for (Eigen::Index b = 0; b < shape.predictions; ++b)
        {
            AssignmentPair pair{b, b, z.segment(O * j, O) - h.segment(O * b, O), {}};
            if (shape.ownNoise) pair.R = Eigen::MatrixXd::Identity(O, O);
            if (pair.nu.dot(S.block(O * b, O * b, O, O).llt().solve(pair.nu)) < limit)
                problem.items.back().push_back(std::move(pair));
        }
    }
    for (int k = 0; k <= shape.items; ++k) problem.limits.push_back(chi2Limit(O * k, 0.95));
    return problem;
}

/** D2 and ln |S| of an assignment by dense matrices. */
inline void measureDensely(const AssignmentProblem& problem, AssignmentResult& result)
{
    const Eigen::Index O = problem.dimension;
    std::vector<AssignmentPair> pairs;
    for (std::size_t i = 0; i < result.chosen.size(); ++i)
        if (result.chosen[i] >= 0)
            pairs.push_back(problem.items[i][static_cast<std::size_t>(result.chosen[i])]);
    result.pairs = static_cast<long>(pairs.size());
    const Eigen::Index n = O * static_cast<Eigen::Index>(pairs.size());
    Eigen::MatrixXd S(n, n);
    Eigen::VectorXd nu(n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        const AssignmentPair& a = pairs[static_cast<std::size_t>(i / O)];
        nu(i) = a.nu(i % O);
        for (Eigen::Index j = 0; j < n; ++j)
        {
            const AssignmentPair& b = pairs[static_cast<std::size_t>(j / O)];
            S(i, j) = problem.HPHt(O * a.block + i % O, O * b.block + j % O);
            if (i / O == j / O && a.R.size() > 0) S(i, j) += a.R(i % O, j % O);
        }
    }
    result.d2 = n == 0 ? 0.0 : nu.dot(S.ldlt().solve(nu));
    result.logDet = n == 0 ? 0.0 : std::log(S.determinant());
}

/** The definition: every assignment there is. */
class EveryAssignment
{
   public:
    explicit EveryAssignment(const AssignmentProblem& problem) : problem_(problem)
    {
        best_.chosen.assign(problem.items.size(), -1);
        chosen_ = best_.chosen;
        visit(0);
    }
    [[nodiscard]] const AssignmentResult& best() const { return best_; }

   private:
    void visit(std::size_t i)
    {
        if (i == chosen_.size()) return judge();
        visit(i + 1);
        for (std::size_t c = 0; c < problem_.items[i].size(); ++c)
        {
            if (!used_.insert(problem_.items[i][c].use).second) continue;
            chosen_[i] = static_cast<int>(c);
            visit(i + 1);
            chosen_[i] = -1;
            used_.erase(problem_.items[i][c].use);
        }
    }
    void judge()
    {
        AssignmentResult result;
        result.chosen = chosen_;
        measureDensely(problem_, result);
        if (result.d2 > problem_.limits[static_cast<std::size_t>(result.pairs)]) return;
        const bool better = result.pairs > best_.pairs ||
                            (result.pairs == best_.pairs &&
                             result.cost(problem_.likelihood) < best_.cost(problem_.likelihood));
        if (better) best_ = result;
    }

    const AssignmentProblem& problem_;
    std::set<Eigen::Index> used_;
    std::vector<int> chosen_;
    AssignmentResult best_;
};
}  // namespace monoslam::test
