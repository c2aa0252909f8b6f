// Ctrl-C. Before a render there is nothing to save and the program ends at once; during one it is asked to stop.
#pragma once

namespace ups::tool {

void install_interrupt_handler();
// Between these calls an interrupt only sets the flag; a second one ends the program.
void begin_interruptible_work();
bool interrupted();

}  // namespace ups::tool
