// Linked into every test of a build with UPS_FLOAT_TRAPS: the main thread traps from the start, and a trap tells where.
// Addresses without names: addr2line -Cfie TEST ADDRESS.
#include <execinfo.h>
#include <signal.h>
#include <unistd.h>

#include <cfenv>

namespace {

void tell(int) {
  static const char text[] = "a float trap: an invalid operation, a division by zero or an overflow at\n";
  if (write(2, text, sizeof text - 1) < 0) _exit(3);
  void* frames[64];
  backtrace_symbols_fd(frames, backtrace(frames, 64), 2);
  _exit(3);
}

[[maybe_unused]] const bool traps = [] {
  struct sigaction action {};
  action.sa_handler = tell;
  sigaction(SIGFPE, &action, nullptr);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  return true;
}();

}  // namespace
