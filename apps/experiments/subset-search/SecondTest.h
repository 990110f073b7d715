// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "monoslam_association/largestCompatibleSubset.h"

namespace monoslam
{
/** What a jointly compatible set is tested for once more, pair by pair, worst first. */
enum class SecondRule
{
    None,
    Conditional,  ///< w_j, the NIS given all others, above chi2(2, p)
    Joint,        ///< while D2 of the set is above chi2(2k, p): w_j above chi2(2, 0.95)
    Likelihood,   ///< density given all others below that of a wrong pair anywhere in its gate,
                  ///< times the odds (1 - p) / p of a wrong pair
};

struct SecondTest
{
    SecondRule rule = SecondRule::None;
    double p = 1.0;
    bool putBack = false;  ///< then accepts removed pairs that the same test passes
    [[nodiscard]] std::string name() const;
};

/** \param removed  of the problem's pairs; \return those that are removed after the test */
[[nodiscard]] std::vector<Eigen::Index> applySecondTest(const SubsetProblem& problem,
                                                        std::vector<Eigen::Index> removed,
                                                        const SecondTest& test);
}  // namespace monoslam
