// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_association/AssignmentProblem.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** Every pair of an assignment problem given a stack of accepted ones.
 *
 *      pushing pair p of block b:   L L' = S_bb|stack + R_p,   e = L^-1 (nu_p - shift_b)
 *      W = L^-1 S_b:|stack,   shift += W' e,   S_jj|stack -= W_j' W_j,   D2 += |e|^2
 *
 * That is what sequential filter updates would do to the predictions, without a filter. O(k N O^3)
 * for k pairs on the stack and N predictions. */
class MONOSLAM_ASSOCIATION_EXPORT ConditionalPairs
{
   public:
    /** \param problem  must outlive this object
     *  \throw std::invalid_argument if its sizes disagree */
    explicit ConditionalPairs(const AssignmentProblem& problem);

    /** \return false, and nothing is pushed, if S would not be positive definite */
    bool push(const AssignmentPair& pair);
    void pop() { --pairs_; }

    [[nodiscard]] Eigen::Index pairs() const { return pairs_; }
    [[nodiscard]] double d2() const { return d2_[static_cast<std::size_t>(pairs_)]; }
    [[nodiscard]] double logDet() const { return logDet_[static_cast<std::size_t>(pairs_)]; }

    /** What pushing the pair would add to D2 and ln |S|. */
    struct Gain
    {
        double nis = 0.0;  ///< infinite if S would not be positive definite
        double logDet = 0.0;
    };
    [[nodiscard]] Gain gain(const AssignmentPair& pair) const;

   private:
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    template <int O>
    [[nodiscard]] Gain gainOf(const AssignmentPair& pair) const;

    const AssignmentProblem& problem_;
    Eigen::Index O_;
    RowMajor W_;      ///< O rows a pair
    RowMajor shift_;  ///< a row for each height of the stack, of all predictions
    RowMajor S_;      ///< O rows for each height: the diagonal blocks side by side
    std::vector<double> d2_, logDet_;
    Eigen::Index pairs_ = 0;
};
}  // namespace monoslam
