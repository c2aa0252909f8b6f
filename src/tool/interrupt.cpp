// See interrupt.h. The handler does only what a signal handler may: it sets a flag, or ends the program.
#include "tool/interrupt.h"

#include <unistd.h>
#include <csignal>

#include "tool/commands.h"

namespace ups::tool {

namespace {

volatile std::sig_atomic_t working = 0, seen = 0;

extern "C" void on_interrupt(int) {
  if (!working || seen) _exit(exit_interrupted);
  seen = 1;
}

}  // namespace

void install_interrupt_handler() { std::signal(SIGINT, on_interrupt); }
void begin_interruptible_work() { working = 1; }
bool interrupted() { return seen != 0; }

}  // namespace ups::tool
