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

    /** The paths from one row that Dijkstra's search has found so far. */
    struct Paths
    {
        Eigen::VectorXd distance;        ///< to every column
        std::vector<Eigen::Index> from;  ///< column before it
        std::vector<bool> isDone;
        std::vector<Eigen::Index> done;
        double reached = 0.0;

        explicit Paths(Eigen::Index columns)
            : distance(Eigen::VectorXd::Constant(columns, std::numeric_limits<double>::infinity())),
              from(static_cast<std::size_t>(columns), kNone),
              isDone(static_cast<std::size_t>(columns), false)
        {
        }
    };

    /** Through a row, which is reached by \p column: the nearest column not done. */
    [[nodiscard]] Eigen::Index extend(Paths& paths, Eigen::Index row, Eigen::Index column) const
    {
        Eigen::Index nearest = kNone;
        for (Eigen::Index j = 0; j < cost_.cols(); ++j)
        {
            if (paths.isDone[static_cast<std::size_t>(j)]) continue;
            const double through = paths.reached + cost_(row, j) - u_(row) - v_(j);
            if (through < paths.distance(j))
            {
                paths.distance(j) = through;
                paths.from[static_cast<std::size_t>(j)] = column;
            }
            if (nearest == kNone || paths.distance(j) < paths.distance(nearest)) nearest = j;
        }
        return nearest;
    }

    void augment(Eigen::Index start)
    {
        Paths paths(cost_.cols());
        Eigen::Index row = start;
        Eigen::Index column = kNone;
        while (row != kNone)
        {
            column = extend(paths, row, column);
            paths.reached = paths.distance(column);
            paths.isDone[static_cast<std::size_t>(column)] = true;
            paths.done.push_back(column);
            row = rowOf_[static_cast<std::size_t>(column)];
        }
        u_(start) += paths.reached;
        for (const Eigen::Index j : paths.done)
        {
            const Eigen::Index owner = rowOf_[static_cast<std::size_t>(j)];
            if (owner != kNone) u_(owner) += paths.reached - paths.distance(j);
            v_(j) -= paths.reached - paths.distance(j);
        }
        while (column != kNone)
        {
            const Eigen::Index before = paths.from[static_cast<std::size_t>(column)];
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
