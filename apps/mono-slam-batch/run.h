// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Arguments.h"

namespace monoslam
{
/** The whole program. \return exit status: 0, 1 if a job has failed, 128 + signal after Ctrl-C
 *  \throw std::exception with one line for people */
int run(const Arguments& arguments);
}  // namespace monoslam
