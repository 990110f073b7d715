// SPDX-License-Identifier: BSD-3-Clause
#include "Interrupt.h"

#include <csignal>
#include <initializer_list>

namespace monoslam
{
namespace
{
volatile std::sig_atomic_t noted = 0;

void onInterrupt(int signal)
{
    noted = signal;
    std::signal(signal, SIG_DFL);
}
}  // namespace

void noteInterrupts()
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, onInterrupt);
}

int interruptSignal()
{
    return noted;
}
}  // namespace monoslam
