// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include "subsetSearches.h"
namespace monoslam
{
bool searchByRemovals(const SubsetProblem&, const DowndatingD2&, long, SubsetIncumbent&, SubsetResult&)
{ return false; }
}
