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

// Ctrl-C a second time ends at once; a hang-up after a request to end does not: some send both.
void take_interrupt(int exit_code) {
  constexpr int ctrl_c = 130;
  if (!working || (seen != 0 && exit_code == ctrl_c)) std::_Exit(exit_code);
  if (seen == 0) seen = exit_code;
}

}  // namespace

void install_interrupt_handler() { platform::on_interrupt(take_interrupt); }
void begin_interruptible_work() { working = true; }
int interruption() { return seen; }

}  // namespace ups::tool
