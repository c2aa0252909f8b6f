// See process.h: the terminal, Ctrl-C and other signals that end a program.
#include <csignal>

#include <sys/ioctl.h>
#include <unistd.h>

#include "platform/process.h"

namespace ups::platform {

namespace {

void (*interrupted)(int exit_code) = nullptr;

extern "C" void on_signal(int number) { interrupted(128 + number); }

bool is_ignored(int number) {
  struct sigaction now {};
  return ::sigaction(number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

std::vector<std::string> program_arguments(int argc, char** argv) { return {argv + (argc > 0), argv + argc}; }

bool standard_error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

int terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void let_large_files_fail() { std::signal(SIGXFSZ, SIG_IGN); }

void on_interrupt(void (*handler)(int exit_code)) {
  interrupted = handler;
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(number)) std::signal(number, on_signal);
}

}  // namespace ups::platform
