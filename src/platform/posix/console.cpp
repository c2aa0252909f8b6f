// See process.h: the terminal and Ctrl-C.
#include <csignal>

#include <sys/ioctl.h>
#include <unistd.h>

#include "platform/process.h"

namespace ups::platform {

namespace {

void (*interrupted)() = nullptr;

extern "C" void on_signal(int) { interrupted(); }

}  // namespace

std::vector<std::string> program_arguments(int argc, char** argv) { return {argv + (argc > 0), argv + argc}; }

bool standard_error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

int terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void let_large_files_fail() { std::signal(SIGXFSZ, SIG_IGN); }

void on_interrupt(void (*handler)()) {
  interrupted = handler;
  std::signal(SIGINT, on_signal);
}

}  // namespace ups::platform
