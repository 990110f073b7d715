// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** Makes MRPT know the classes that rawlogs and scenes are made of. Loading the library as a plugin
 *  (RawLogViewer -l, rawlog-edit -p) calls it; so do our readers. */
MONOSLAM_MRPT_EXPORT void registerAllClasses();
}  // namespace monoslam
