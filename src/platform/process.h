// The program and its surroundings. Called by src/tool alone.
#pragma once
#include <string>
#include <vector>

namespace ups::platform {

// The words after the program's name, in UTF-8; lets the console show UTF-8 too, where that must be asked for.
std::vector<std::string> program_arguments(int argc, char** argv);

// Where the running program's file is; empty where that cannot be found out.
std::string program_file();

bool standard_error_is_terminal();
// Of that terminal; 80 where it does not tell.
int terminal_columns();

// A file that grows beyond what the process may write (ulimit -f) ends it no more: writing fails.
void let_large_files_fail();

// Ctrl-C calls this from now on, and so do what ends a job (SIGTERM) and a terminal that is gone (SIGHUP); each only
// where the process was not started to ignore it, as in the background or by nohup. exit_code: 128 and the signal's
// number, as shells tell it; 130 of Ctrl-C. It is called within a signal handler or on a thread of the system's: it may
// set lock-free atomics and call std::_Exit().
void on_interrupt(void (*handler)(int exit_code));

}  // namespace ups::platform
