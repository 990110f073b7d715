// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/makeEngine.h"

#include "monoslam_mrpt/MonoSlamKF.h"

namespace monoslam
{
FilterEngine makeEngine(EngineName name)
{
    return name == EngineName::Mrpt ? makeMrptEngine() : FilterEngine{};
}
}  // namespace monoslam
