// How much memory this process may still take before the system ends it: of the machine, and of the control groups that
// it is in. Asked by a render before it starts.
#pragma once
#include <cstdint>
#include <string>

namespace ups {

struct AvailableMemory {
  uint64_t bytes = UINT64_MAX;  // that can still be taken
  std::string limit;            // what ends there, in words
};

// root: before the names of the system's files; a test has its own. Control groups of versions 1 and 2, with all that
// they lie in: their limit less what they use, but for cached files, which the system drops first. What cannot be read
// limits nothing.
AvailableMemory available_memory(const std::string& root = "");

}  // namespace ups
