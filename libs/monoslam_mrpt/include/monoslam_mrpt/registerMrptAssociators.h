// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** Adds the strategies that call MRPT to makeAssociator(): jcbb_mrpt. Calling it twice is as good
 *  as once. */
MONOSLAM_MRPT_EXPORT void registerMrptAssociators();
}  // namespace monoslam
