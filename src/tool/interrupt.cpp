// See interrupt.h. The handler does only what one may that comes at any time: it sets a flag, or ends the program.
#include "tool/interrupt.h"

#include <atomic>
#include <cstdlib>

#include "platform/process.h"
#include "tool/commands.h"

namespace ups::tool {

namespace {

std::atomic<bool> working = false, seen = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void take_interrupt() {
  if (!working || seen) std::_Exit(exit_interrupted);
  seen = true;
}

}  // namespace

void install_interrupt_handler() { platform::on_interrupt(take_interrupt); }
void begin_interruptible_work() { working = true; }
bool interrupted() { return seen; }

}  // namespace ups::tool
