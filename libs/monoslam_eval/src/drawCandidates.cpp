// SPDX-License-Identifier: BSD-3-Clause
#include "drawCandidates.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
/** A place that is not found so often does not exist. */
constexpr int kTries = 10000;

double score(std::normal_distribution<double> all, double lowest, std::mt19937& rng)
{
    double drawn = all(rng);
    while (drawn < lowest || drawn > 1.0) drawn = all(rng);
    return drawn;
}

Eigen::Vector2d wrongPixel(const PredictedLandmark& row, const Eigen::Vector2d& right,
                           const ProblemDistributions& drawn, std::mt19937& rng)
{
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const Eigen::Matrix2d L = row.S.llt().matrixL();
    const double radius = std::sqrt(chi2Limit(2, drawn.gateProbability));
    for (int tries = 0; tries < kTries; ++tries)
    {
        const double e = uniform(rng);
        const Eigen::Vector2d inCircle(e, uniform(rng));
        const Eigen::Vector2d z = row.h + radius * (L * inCircle);
        if (inCircle.squaredNorm() < 1.0 && (z - right).norm() >= drawn.wrongDistance_px) return z;
    }
    throw std::invalid_argument("drawProblem: an ellipse has no place for a wrong candidate");
}
}  // namespace

std::vector<Candidate> drawCandidates(const PredictedLandmark& row, const CandidateDraw& draw,
                                      const ProblemDistributions& drawn, std::mt19937& rng)
{
    const std::normal_distribution<double> rights(drawn.rightScore, drawn.rightScoreSigma);
    const std::normal_distribution<double> wrongs(drawn.wrongScore, drawn.wrongScoreSigma);
    std::vector<Candidate> found;
    if (!draw.absent) found.push_back({draw.right, score(rights, drawn.minScore, rng), row.R});
    while (static_cast<int>(found.size()) < draw.count)
    {
        const Eigen::Vector2d z = wrongPixel(row, draw.right, drawn, rng);
        found.push_back({z, score(wrongs, drawn.minScore, rng), row.R});
    }
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    return found;
}
}  // namespace monoslam
