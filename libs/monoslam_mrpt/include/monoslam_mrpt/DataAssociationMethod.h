// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/slam/data_association.h>

namespace monoslam
{
/** Ways of associating observations with the predictions of a map, under the names and values of
 *  mrpt::slam::TDataAssociationMethod where it has them.
 *
 * An ini names them NN, JCBB, HOHCT, MHDA, NN_MRPT, JCBB_MRPT, or as here. */
// NOLINTBEGIN(readability-identifier-naming): MRPT's names, so that a change of namespace suffices
enum DataAssociationMethod : int  // MRPT's reader makes any number one, known or not
{
    assocNN = mrpt::slam::assocNN,      ///< nearest neighbours
    assocJCBB = mrpt::slam::assocJCBB,  ///< joint compatibility branch and bound, with its test
    assocHOHCT,                         ///< the largest jointly compatible assignment, exactly
    assocMHDA,                          ///< drawn, by several filters: RangeBearingMhda
    assocNN_MRPT,                       ///< MRPT's own, to compare with
    assocJCBB_MRPT,
};
using mrpt::slam::metricMaha;
using mrpt::slam::metricML;
// NOLINTEND(readability-identifier-naming)
}  // namespace monoslam

// The name inserted last is the one that is printed.
MRPT_ENUM_TYPE_BEGIN(monoslam::DataAssociationMethod)
MRPT_FILL_ENUM_MEMBER(monoslam, assocNN);
MRPT_FILL_ENUM_MEMBER(monoslam, assocJCBB);
MRPT_FILL_ENUM_MEMBER(monoslam, assocHOHCT);
MRPT_FILL_ENUM_MEMBER(monoslam, assocMHDA);
MRPT_FILL_ENUM_MEMBER(monoslam, assocNN_MRPT);
MRPT_FILL_ENUM_MEMBER(monoslam, assocJCBB_MRPT);
MRPT_FILL_ENUM_CUSTOM_NAME(monoslam::assocNN, "NN");
MRPT_FILL_ENUM_CUSTOM_NAME(monoslam::assocJCBB, "JCBB");
MRPT_FILL_ENUM_CUSTOM_NAME(monoslam::assocHOHCT, "HOHCT");
MRPT_FILL_ENUM_CUSTOM_NAME(monoslam::assocMHDA, "MHDA");
MRPT_FILL_ENUM_CUSTOM_NAME(monoslam::assocNN_MRPT, "NN_MRPT");
MRPT_FILL_ENUM_CUSTOM_NAME(monoslam::assocJCBB_MRPT, "JCBB_MRPT");
MRPT_ENUM_TYPE_END()
