// Ctrl-C, SIGTERM, SIGHUP. Before a render there is nothing to save and the program ends at once; during one it is asked
// to stop.
#pragma once

namespace ups::tool {

void install_interrupt_handler();
// Between these calls an interrupt only sets the flag; Ctrl-C after it ends the program.
void begin_interruptible_work();
int interruption();  // the program's exit code then; 0: there was none

}  // namespace ups::tool
