// See process.h: the command line, the console and Ctrl-C.
#include <cstdlib>

#include "platform/process.h"
#include "platform/windows/system.h"

#include <shellapi.h>

namespace ups::platform {

namespace {

constexpr int exit_by_ctrl_c = 130;
void (*interrupted)(int exit_code) = nullptr;

BOOL WINAPI on_event(DWORD event) {
  if (event != CTRL_C_EVENT) return FALSE;
  interrupted(exit_by_ctrl_c);
  return TRUE;
}

}  // namespace

// Of the system's own: argv is in the code page, which lacks most characters.
std::vector<std::string> program_arguments(int argc, char** argv) {
  SetConsoleOutputCP(CP_UTF8);
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  if (!words) return {argv + (argc > 0), argv + argc};
  std::vector<std::string> arguments;
  for (int i = 1; i < count; ++i) arguments.push_back(utf8_of(words[i]));
  LocalFree(words);
  return arguments;
}

bool standard_error_is_terminal() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

int terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (!GetConsoleScreenBufferInfo(GetStdHandle(STD_ERROR_HANDLE), &info)) return 80;
  return info.srWindow.Right - info.srWindow.Left + 1;
}

void let_large_files_fail() {}  // there is no such limit

void on_interrupt(void (*handler)(int exit_code)) {
  interrupted = handler;
  SetConsoleCtrlHandler(on_event, TRUE);
}

}  // namespace ups::platform
