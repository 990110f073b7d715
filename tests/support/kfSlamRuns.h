// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "runProgram.h"

namespace monoslam
{
inline ProgramResult kfSlamJoint(const std::string& arguments)
{
    return runProgram("kf-slam-joint", arguments);
}

inline std::string setting(const std::string& keyAndValue)
{
    return " --set '" + keyAndValue + "'";
}

inline std::string method(const std::string& name)
{
    return setting("RangeBearingKFSLAM.data_assoc_method=" + name);
}
}  // namespace monoslam
