// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace monoslam
{
/** From now on the first Ctrl-C, SIGTERM or SIGHUP is noted; the second ends the program. */
void noteInterrupts();

/** The signal that came, or 0. */
[[nodiscard]] int interruptSignal();
}  // namespace monoslam
