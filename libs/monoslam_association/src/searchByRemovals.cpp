// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "RemovalTree.h"

namespace monoslam
{
bool searchByRemovals(const DowndatingD2& whole, NodeAllowance& allowance,
                      SubsetIncumbent& incumbent, SubsetResult& result)
{
    RemovalTree tree(allowance, incumbent, result);
    RemovalTree::Node& root = tree.root();
    root.pairs.resize(static_cast<std::size_t>(whole.weighted().size() / 2));
    std::iota(root.pairs.begin(), root.pairs.end(), Eigen::Index{0});
    root.Lam.gather(whole.precision(), root.pairs);
    root.gt = gatherRows(whole.weighted(), root.pairs).reshaped(whole.weighted().size() / 2, 2);
    root.d2 = whole.d2();
    return tree.search({});
}
}  // namespace monoslam
