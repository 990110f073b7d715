// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace monoslam
{
/** One way of pairing an item. */
struct AssignmentPair
{
    Eigen::Index block = 0;  ///< of the prediction in HPHt
    Eigen::Index use = 0;    ///< what it uses up: no two pairs of an assignment have the same
    Eigen::VectorXd nu;      ///< z - h, O numbers
    Eigen::MatrixXd R;       ///< noise of z, O x O; empty if HPHt contains it
};

/** Items to be paired, each at most once, whose candidates may be wanted by several.
 *
 * In MRPT's range-bearing SLAM an item is an observation, its candidates are the compatible
 * predictions, and a prediction is used once. In a monocular filter an item is a landmark, its
 * block is always the same, and a pixel is used once. */
struct AssignmentProblem
{
    Eigen::Index dimension = 2;  ///< O, of one measurement
    Eigen::MatrixXd HPHt;        ///< joint covariance of the N predictions, NO x NO
    std::vector<std::vector<AssignmentPair>> items;  ///< candidates of each; may be empty
    std::vector<double> limits;  ///< of D2 of 0, 1, ... pairs; grows; items + 1 entries
    bool likelihood = false;     ///< of equal sizes: the most likely, not the least D2
};

struct AssignmentResult
{
    std::vector<int> chosen;  ///< candidate of each item, -1 = none
    long pairs = 0;
    double d2 = 0.0;      ///< joint squared Mahalanobis distance of the pairs
    double logDet = 0.0;  ///< ln |S| of the pairs
    bool proved = true;   ///< false: the node cap ended the search
    long nodes = 0;

    /** The lower the better among assignments of one size. */
    [[nodiscard]] double cost(bool likelihood) const { return likelihood ? d2 + logDet : d2; }
};
}  // namespace monoslam
