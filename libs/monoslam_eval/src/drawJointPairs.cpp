// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "monoslam_association/jointCompatibility.h"
#include "monoslam_eval/JointPairs.h"

namespace monoslam
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr int kAttempts = 2000;
constexpr double kLeastOffset_px = 4.0, kMostOffset_px = 20.0;

double uniform(double least, double most, std::mt19937& rng)
{
    return std::uniform_real_distribution<double>(least, most)(rng);
}

bool inGate(const Eigen::MatrixXd& S, Eigen::Index j, const Eigen::Vector2d& nu_j, double limit)
{
    const Eigen::Matrix2d S_jj = S.block<2, 2>(2 * j, 2 * j);
    return nu_j.dot(S_jj.llt().solve(nu_j)) <= limit;
}

/** Pairs of one draw that are seen, at most as many as wanted. */
std::vector<Eigen::Index> pairsSeen(const JointPrior& prior, const Eigen::VectorXd& nu,
                                    Eigen::Index most, double limit)
{
    std::vector<Eigen::Index> seen;
    for (Eigen::Index j = 0; j < nu.size() / 2; ++j)
        if (static_cast<Eigen::Index>(seen.size()) < most &&
            inGate(prior.S, j, nu.segment<2>(2 * j), limit))
            seen.push_back(j);
    return seen;
}

void spoilEach(JointPairs& pairs, Eigen::Index wrong, double limit, std::mt19937& rng)
{
    std::vector<Eigen::Index> order(pairs.wrong.size());
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::shuffle(order.begin(), order.end(), rng);
    order.resize(static_cast<std::size_t>(wrong));
    for (const Eigen::Index j : order)
    {
        const Eigen::Matrix2d S_jj = pairs.S.block<2, 2>(2 * j, 2 * j);
        const double angle = uniform(0.0, 2.0 * kPi, rng);
        const double radius = std::sqrt(limit * uniform(0.0, 1.0, rng));
        pairs.nu.segment<2>(2 * j) =
            S_jj.llt().matrixL() *
            Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
        pairs.wrong[static_cast<std::size_t>(j)] = 1;
    }
}

/** \return false if the offset drawn takes one out of its gate */
bool shiftNeighbors(JointPairs& pairs, const std::vector<Eigen::Vector2d>& pixels,
                    Eigen::Index wrong, double limit, std::mt19937& rng)
{
    std::vector<Eigen::Index> order(pairs.wrong.size());
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto& centre =
        pixels[std::uniform_int_distribution<std::size_t>(0, pixels.size() - 1)(rng)];
    const auto distance = [&](Eigen::Index j)
    { return (pixels[static_cast<std::size_t>(j)] - centre).squaredNorm(); };
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index a, Eigen::Index b) { return distance(a) < distance(b); });
    order.resize(static_cast<std::size_t>(wrong));
    const double angle = uniform(0.0, 2.0 * kPi, rng);
    const Eigen::Vector2d offset = uniform(kLeastOffset_px, kMostOffset_px, rng) *
                                   Eigen::Vector2d(std::cos(angle), std::sin(angle));
    for (const Eigen::Index j : order)
        if (!inGate(pairs.S, j, pairs.nu.segment<2>(2 * j) + offset, limit)) return false;
    for (const Eigen::Index j : order)
    {
        pairs.nu.segment<2>(2 * j) += offset;
        pairs.wrong[static_cast<std::size_t>(j)] = 1;
    }
    return true;
}

JointPairs select(const JointPrior& prior, const Eigen::VectorXd& nu,
                  const std::vector<Eigen::Index>& seen)
{
    const auto m = static_cast<Eigen::Index>(seen.size());
    JointPairs pairs{Eigen::MatrixXd(2 * m, 2 * m), Eigen::VectorXd(2 * m),
                     std::vector<char>(seen.size(), 0)};
    for (Eigen::Index l = 0; l < m; ++l)
    {
        const Eigen::Index from = 2 * seen[static_cast<std::size_t>(l)];
        pairs.nu.segment<2>(2 * l) = nu.segment<2>(from);
        for (Eigen::Index j = 0; j < m; ++j)
            pairs.S.block<2, 2>(2 * l, 2 * j) =
                prior.S.block<2, 2>(from, 2 * seen[static_cast<std::size_t>(j)]);
    }
    return pairs;
}
}  // namespace

Eigen::Index landmarksFor(Eigen::Index pairs)
{
    return pairs + pairs / 6 + 4;
}

JointPairs drawJointPairs(const JointPrior& prior, const JointPairsOptions& options,
                          std::mt19937& rng)
{
    const double limit = chi2Limit(2, options.gateProbability);
    const Eigen::LLT<Eigen::MatrixXd> llt(prior.S);
    std::normal_distribution<double> normal;
    for (int attempt = 0; attempt < kAttempts; ++attempt)
    {
        const Eigen::VectorXd nu =
            llt.matrixL() *
            Eigen::VectorXd::NullaryExpr(prior.S.rows(), [&] { return normal(rng); }).eval();
        const auto seen = pairsSeen(prior, nu, options.pairs, limit);
        if (static_cast<Eigen::Index>(seen.size()) < options.pairs) continue;
        JointPairs pairs = select(prior, nu, seen);
        if (options.outliers == OutlierKind::Uniform)
        {
            spoilEach(pairs, options.wrong, limit, rng);
            return pairs;
        }
        std::vector<Eigen::Vector2d> pixels;
        for (const Eigen::Index j : seen)
            pixels.push_back(prior.pixels[static_cast<std::size_t>(j)]);
        for (int shift = 0; shift < kAttempts / 10; ++shift)
            if (shiftNeighbors(pairs, pixels, options.wrong, limit, rng)) return pairs;
    }
    throw std::runtime_error("drawJointPairs: too few landmarks lie in their gates");
}
}  // namespace monoslam
