// How much memory this process may still take before the system ends it, and how much it has.
#pragma once
#include <cstdint>
#include <string>

namespace ups::platform {

struct AvailableMemory {
  uint64_t bytes = UINT64_MAX;  // that can still be taken
  std::string limit;            // what ends there, in words
};

// Of the machine, and of the groups of processes that this one is in. Asked by renders and commits. What cannot
// be read limits nothing.
AvailableMemory available_memory();

// In physical memory now, and at most so far; 0 where that cannot be read.
uint64_t resident_bytes();
uint64_t peak_resident_bytes();

}  // namespace ups::platform
