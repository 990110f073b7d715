// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "monoslam_association/export.h"

namespace monoslam
{
/** tau-quantile of the chi-square distribution; 0 for dof = 0, infinite for tau >= 1. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT double chi2Limit(Eigen::Index dof, double tau);

/** The quantiles of one tau for dof = 0 .. maxDof, computed once. */
class MONOSLAM_ASSOCIATION_EXPORT Chi2Table
{
   public:
    explicit Chi2Table(double tau, Eigen::Index maxDof = 400);
    [[nodiscard]] double operator()(Eigen::Index dof) const;
    [[nodiscard]] double tau() const { return tau_; }

   private:
    double tau_;
    std::vector<double> quantiles_;
};

/** One pair: its row in HPHt, innovation nu = z - h [px] and noise R [px^2]. */
struct JointPair
{
    Eigen::Index row = 0;
    Eigen::Vector2d nu = Eigen::Vector2d::Zero();
    Eigen::Matrix2d R = Eigen::Matrix2d::Zero();
};

/** Joint Mahalanobis distance of a stack of pairs, one pair pushed or popped at a time.
 *
 *      S = L L',  e = L^-1 nu,  D2 = |e|^2;   pushing pair j:
 *      Y = L^-1 S_:j,  C C' = S_jj - Y'Y,  e_j = C^-1 (nu_j - Y'e),  D2+ = D2 + |e_j|^2
 *
 * O(k^2) for k pairs and no allocation after construction. D2 never falls when a pair is added.
 * The same recursion on (S^-1, S^-1 nu) gives the gain of removing pairs (algorithms 6.4). */
class MONOSLAM_ASSOCIATION_EXPORT IncrementalD2
{
   public:
    /** \param HPHt  m blocks of 2, must outlive this object; \param capacity  pairs on the stack */
    IncrementalD2(const Eigen::MatrixXd& HPHt, Eigen::Index capacity);

    /** \return false, and nothing is pushed, if S would not be positive definite */
    bool push(const JointPair& pair);
    void pop() { --pairs_; }
    [[nodiscard]] Eigen::Index pairs() const { return pairs_; }
    [[nodiscard]] double d2() const { return d2_[static_cast<std::size_t>(pairs_)]; }

   private:
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    const Eigen::MatrixXd& HPHt_;
    RowMajor L_;
    Eigen::VectorXd e_;
    std::vector<Eigen::Index> rows_;
    std::vector<double> d2_;  ///< after 0, 1, ... pairs
    Eigen::Index pairs_ = 0;
};

/** Joint Mahalanobis distance of a set from which pairs are removed.
 *
 *      Lam = S^-1,  gt = Lam nu,  D2 = nu'gt,  w_j = gt_j' Lam_jj^-1 gt_j;   removing pair j:
 *      gt -= Lam_:j Lam_jj^-1 gt_j,  Lam -= Lam_:j Lam_jj^-1 Lam_j:,  D2 -= w_j
 *
 * w_j is the NIS of pair j given all others. O(m^3) once, O(m^2) a removal. */
class MONOSLAM_ASSOCIATION_EXPORT DowndatingD2
{
   public:
    DowndatingD2(const Eigen::MatrixXd& S, const Eigen::VectorXd& nu);
    DowndatingD2(const Eigen::LLT<Eigen::MatrixXd>& factorOfS, const Eigen::VectorXd& nu);

    /** False if S is not positive definite; nothing else may be called then. */
    [[nodiscard]] bool valid() const { return valid_; }
    [[nodiscard]] double d2() const { return d2_; }
    [[nodiscard]] double conditionalNis(Eigen::Index pair) const;
    void remove(Eigen::Index pair);
    [[nodiscard]] bool removed(Eigen::Index pair) const
    {
        return removed_[static_cast<std::size_t>(pair)];
    }
    /** Pair of largest conditionalNis, -1 if none is left. */
    [[nodiscard]] Eigen::Index worst() const;

    /** Rows and columns of removed pairs are meaningless. */
    [[nodiscard]] const Eigen::MatrixXd& precision() const { return Lam_; }
    [[nodiscard]] const Eigen::VectorXd& weighted() const { return gt_; }

   private:
    Eigen::MatrixXd Lam_;
    Eigen::VectorXd gt_;
    std::vector<bool> removed_;
    double d2_ = 0.0;
    bool valid_ = false;
};
}  // namespace monoslam
