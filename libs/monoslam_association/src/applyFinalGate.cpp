// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>

#include "BatchSearch.h"
#include "ConditionalPrediction.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
void removeWorst(const AssociationProblem& problem, double limit, std::vector<int>& chosen)
{
    std::vector<std::size_t> entries;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] >= 0) entries.push_back(i);
    const JointInnovation joint = stackInnovation(*problem.prediction, pixelsOf(problem, chosen));
    DowndatingD2 accepted(joint.S, joint.nu);
    if (!accepted.valid()) return;
    for (Eigen::Index j = accepted.worst(); j >= 0; j = accepted.worst())
    {
        if (accepted.conditionalNis(j) <= limit) return;
        accepted.remove(j);
        chosen[entries[static_cast<std::size_t>(j)]] = -1;
    }
}

bool taken(const AssociationProblem& problem, const std::vector<int>& chosen,
           const Eigen::Vector2d& z)
{
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] >= 0 && problem.candidates[i][static_cast<std::size_t>(chosen[i])].z == z)
            return true;
    return false;
}

void putBack(const AssociationProblem& problem, double limit, std::vector<int>& chosen)
{
    const auto pixels = pixelsOf(problem, chosen);
    if (pixels.size() < kPoseFixingPairs || pixels.size() == chosen.size()) return;
    const ConditionalPrediction given(*problem.prediction, pixels);
    if (!given.valid()) return;
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        if (chosen[i] >= 0) continue;
        const Eigen::Index row = problem.rows[i];
        const auto conditional = given.row(row);
        const Eigen::Vector2d h =
            problem.prediction->rows[static_cast<std::size_t>(row)].h + conditional.shift;
        double least = limit;
        for (std::size_t c = 0; c < problem.candidates[i].size(); ++c)
        {
            const Candidate& candidate = problem.candidates[i][c];
            const Eigen::Matrix2d S = conditional.HPHt + candidate.R;
            const Eigen::Vector2d nu = candidate.z - h;
            const double nis = nu.dot(S.inverse() * nu);
            if (!(nis <= least) || taken(problem, chosen, candidate.z)) continue;
            least = nis;
            chosen[i] = static_cast<int>(c);
        }
    }
}
}  // namespace

std::vector<PixelMeasurement> pixelsOf(const AssociationProblem& problem,
                                       const std::vector<int>& chosen)
{
    std::vector<PixelMeasurement> pixels;
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        if (chosen[i] < 0) continue;
        const Candidate& candidate = problem.candidates[i][static_cast<std::size_t>(chosen[i])];
        pixels.push_back({problem.rows[i], candidate.z, candidate.R});
    }
    return pixels;
}

void applyFinalGate(const AssociationProblem& problem, double limit, std::vector<int>& chosen)
{
    removeWorst(problem, limit, chosen);
    putBack(problem, limit, chosen);
}
}  // namespace monoslam
