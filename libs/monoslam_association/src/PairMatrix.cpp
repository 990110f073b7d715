// SPDX-License-Identifier: BSD-3-Clause
#include "PairMatrix.h"

namespace monoslam
{
void PairMatrix::gather(const PairMatrix& from, const std::vector<Eigen::Index>& pairs)
{
    resize(static_cast<Eigen::Index>(pairs.size()));
    for (Eigen::Index a = 0; a < 2; ++a)
        for (Eigen::Index b = 0; b < 2; ++b)
            for (Eigen::Index j = 0; j < n_; ++j)
            {
                const Eigen::Index c = pairs[static_cast<std::size_t>(j)];
                const double* source = &from.data_(a * from.capacity_, b * from.capacity_ + c);
                double* target = &data_(a * capacity_, b * capacity_ + j);
                for (Eigen::Index l = j; l < n_; ++l)
                    target[l] = source[pairs[static_cast<std::size_t>(l)]];
            }
}

void PairMatrix::gather(const Eigen::MatrixXd& from, const std::vector<Eigen::Index>& pairs)
{
    resize(static_cast<Eigen::Index>(pairs.size()));
    for (Eigen::Index b = 0; b < 2; ++b)
        for (Eigen::Index j = 0; j < n_; ++j)
        {
            const double* source = &from(0, 2 * pairs[static_cast<std::size_t>(j)] + b);
            double* target = &data_(0, b * capacity_ + j);
            for (Eigen::Index l = j; l < n_; ++l)
            {
                const Eigen::Index row = 2 * pairs[static_cast<std::size_t>(l)];
                target[l] = source[row];
                target[capacity_ + l] = source[row + 1];
            }
        }
}

void PairMatrix::addSquare(const Eigen::Ref<const Eigen::MatrixXd>& M, double factor)
{
    for (Eigen::Index a = 0; a < 2; ++a)
        for (Eigen::Index b = 0; b < 2; ++b)
            for (Eigen::Index j = 0; j < n_; ++j)
                plane(a, b).col(j).tail(n_ - j).noalias() +=
                    M.middleRows(a * n_ + j, n_ - j) * (factor * M.row(b * n_ + j).transpose());
}

Eigen::MatrixXd gatherRows(const Eigen::Ref<const Eigen::MatrixXd>& from,
                           const std::vector<Eigen::Index>& pairs)
{
    const auto n = static_cast<Eigen::Index>(pairs.size());
    Eigen::MatrixXd rows(2 * n, from.cols());
    for (Eigen::Index c = 0; c < from.cols(); ++c)
        for (Eigen::Index l = 0; l < n; ++l)
        {
            const Eigen::Index row = 2 * pairs[static_cast<std::size_t>(l)];
            rows(l, c) = from(row, c);
            rows(n + l, c) = from(row + 1, c);
        }
    return rows;
}
}  // namespace monoslam
