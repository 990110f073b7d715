// SPDX-License-Identifier: BSD-3-Clause
#include "bestCandidates.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace monoslam
{
namespace
{
bool usable(const Candidate& candidate)
{
    return candidate.z.allFinite() && std::isfinite(candidate.score) &&
           positiveDefinite(candidate.R);
}

bool better(const Candidate& a, const Candidate& b)
{
    if (a.score != b.score) return a.score > b.score;
    return a.z(1) != b.z(1) ? a.z(1) < b.z(1) : a.z(0) < b.z(0);
}
}  // namespace

bool positiveDefinite(const Eigen::Matrix2d& A)
{
    return A.allFinite() && A(0, 0) > 0.0 && A(1, 1) > 0.0 && A.determinant() > 0.0;
}

std::vector<Candidate> bestCandidates(std::vector<Candidate> found, int most)
{
    found.erase(
        std::remove_if(found.begin(), found.end(), [](const Candidate& c) { return !usable(c); }),
        found.end());
    std::sort(found.begin(), found.end(), better);
    if (found.size() > static_cast<std::size_t>(most)) found.resize(static_cast<std::size_t>(most));
    return found;
}
}  // namespace monoslam
