// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace monoslam
{
/** A vector of two components for each pair; a column holds one component of all pairs. */
using PairVector = Eigen::Array<double, Eigen::Dynamic, 2>;

/** Symmetric matrix of 2 x 2 blocks, block (l, j) for pairs l and j, stored by components: what
 *  runs over the pairs of a column runs through contiguous memory. Only blocks with l >= j count. */
class PairMatrix
{
   public:
    using Plane = Eigen::Block<Eigen::MatrixXd>;
    using ConstPlane = const Eigen::Block<const Eigen::MatrixXd>;

    /** Grows to hold n pairs; the content is lost if it has to grow. */
    void resize(Eigen::Index n)
    {
        n_ = n;
        if (n <= capacity_) return;
        capacity_ = n;
        data_.resize(2 * n, 2 * n);
    }
    [[nodiscard]] Eigen::Index size() const { return n_; }

    /** Components a of row pairs and b of column pairs, n x n. */
    [[nodiscard]] Plane plane(Eigen::Index a, Eigen::Index b)
    {
        return data_.block(a * capacity_, b * capacity_, n_, n_);
    }
    [[nodiscard]] ConstPlane plane(Eigen::Index a, Eigen::Index b) const
    {
        return data_.block(a * capacity_, b * capacity_, n_, n_);
    }

    /** Where the entry of a plane is; those of the pairs after l follow. */
    [[nodiscard]] const double* address(Eigen::Index a, Eigen::Index b, Eigen::Index l,
                                        Eigen::Index j) const
    {
        return &data_(a * capacity_ + l, b * capacity_ + j);
    }

    [[nodiscard]] Eigen::Matrix2d block(Eigen::Index l, Eigen::Index j) const
    {
        if (l < j) return block(j, l).transpose();
        Eigen::Matrix2d B;
        for (Eigen::Index a = 0; a < 2; ++a)
            for (Eigen::Index b = 0; b < 2; ++b)
                B(a, b) = data_(a * capacity_ + l, b * capacity_ + j);
        return B;
    }

    /** Takes the blocks of some pairs of another, which may be 2m x 2m in the usual order. */
    void gather(const PairMatrix& from, const std::vector<Eigen::Index>& pairs);
    void gather(const Eigen::MatrixXd& from, const std::vector<Eigen::Index>& pairs);

    /** Adds factor M M'. \param M  2n rows, first one component of all pairs, then the other */
    void addSquare(const Eigen::Ref<const Eigen::MatrixXd>& M, double factor);

   private:
    Eigen::MatrixXd data_;
    Eigen::Index capacity_ = 0, n_ = 0;
};

/** The rows of some pairs of a matrix in the usual order, first one component, then the other. */
[[nodiscard]] Eigen::MatrixXd gatherRows(const Eigen::Ref<const Eigen::MatrixXd>& from,
                                         const std::vector<Eigen::Index>& pairs);
}  // namespace monoslam
