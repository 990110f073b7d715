// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/leastCostAssignment.h"

#include <limits>
#include <stdexcept>

namespace monoslam
{
namespace
{
/** Shortest augmenting paths, one row after the other; u and v are the dual potentials. */
class Hungarian
{
   public:
    explicit Hungarian(const Eigen::MatrixXd& cost)
        : cost_(cost),
          u_(Eigen::VectorXd::Zero(cost.rows())),
          v_(Eigen::VectorXd::Zero(cost.cols())),
          rowOf_(static_cast<std::size_t>(cost.cols()), kNone)
    {
    }

    std::vector<Eigen::Index> run()
    {
        for (Eigen::Index row = 0; row < cost_.rows(); ++row) augment(row);
        std::vector<Eigen::Index> columnOf(static_cast<std::size_t>(cost_.rows()), kNone);
        for (std::size_t column = 0; column < rowOf_.size(); ++column)
            if (rowOf_[column] != kNone)
                columnOf[static_cast<std::size_t>(rowOf_[column])] =
                    static_cast<Eigen::Index>(column);
        return columnOf;
    }

   private:
    static constexpr Eigen::Index kNone = -1;

    void augment(Eigen::Index start)
    {
        const Eigen::Index columns = cost_.cols();
        Eigen::VectorXd distance =
            Eigen::VectorXd::Constant(columns, std::numeric_limits<double>::infinity());
        std::vector<Eigen::Index> from(static_cast<std::size_t>(columns), kNone);
        std::vector<Eigen::Index> done;
        std::vector<bool> isDone(static_cast<std::size_t>(columns), false);
        Eigen::Index row = start;
        Eigen::Index column = kNone;
        double reached = 0.0;
        while (row != kNone)
        {
            Eigen::Index nearest = kNone;
            for (Eigen::Index j = 0; j < columns; ++j)
            {
                if (isDone[static_cast<std::size_t>(j)]) continue;
                const double through = reached + cost_(row, j) - u_(row) - v_(j);
                if (through < distance(j))
                {
                    distance(j) = through;
                    from[static_cast<std::size_t>(j)] = column;
                }
                if (nearest == kNone || distance(j) < distance(nearest)) nearest = j;
            }
            reached = distance(nearest);
            column = nearest;
            isDone[static_cast<std::size_t>(column)] = true;
            done.push_back(column);
            row = rowOf_[static_cast<std::size_t>(column)];
        }
        u_(start) += reached;
        for (const Eigen::Index j : done)
        {
            const Eigen::Index owner = rowOf_[static_cast<std::size_t>(j)];
            if (owner != kNone) u_(owner) += reached - distance(j);
            v_(j) -= reached - distance(j);
        }
        while (column != kNone)
        {
            const Eigen::Index before = from[static_cast<std::size_t>(column)];
            rowOf_[static_cast<std::size_t>(column)] =
                before == kNone ? start : rowOf_[static_cast<std::size_t>(before)];
            column = before;
        }
    }

    const Eigen::MatrixXd& cost_;
    Eigen::VectorXd u_;
    Eigen::VectorXd v_;
    std::vector<Eigen::Index> rowOf_;
};
}  // namespace

std::vector<Eigen::Index> leastCostAssignment(const Eigen::MatrixXd& cost)
{
    if (cost.cols() < cost.rows())
        throw std::invalid_argument("leastCostAssignment: fewer columns than rows");
    return Hungarian(cost).run();
}
}  // namespace monoslam
