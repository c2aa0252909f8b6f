// See interrupt.h. The handler does only what one may that comes at any time: it sets flags, or ends the program.
#include "tool/interrupt.h"

#include <atomic>
#include <cstdlib>

#include "platform/process.h"

namespace ups::tool {

namespace {

std::atomic<bool> working = false;
std::atomic<int> seen = 0;  // its exit code
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void take_interrupt(int exit_code) {
  if (!working || seen != 0) std::_Exit(exit_code);
  seen = exit_code;
}

}  // namespace

void install_interrupt_handler() { platform::on_interrupt(take_interrupt); }
void begin_interruptible_work() { working = true; }
int interruption() { return seen; }

}  // namespace ups::tool
