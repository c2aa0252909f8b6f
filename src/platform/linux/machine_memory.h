// What limits the process's memory by files like the system's below another root: a test has its own. Control groups of
// versions 1 and 2, with all that they lie in: their limits less what they use, but for cached files, which the system
// drops first; and what they leave of the machine's swap.
#pragma once
#include <string>

#include "platform/memory.h"

namespace ups::platform {

AvailableMemory available_memory_below(const std::string& root);

}  // namespace ups::platform
