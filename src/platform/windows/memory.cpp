// See memory.h.
#include "platform/memory.h"

#include "platform/windows/system.h"

#include <psapi.h>

namespace ups::platform {

namespace {

PROCESS_MEMORY_COUNTERS_EX process_memory() {
  PROCESS_MEMORY_COUNTERS_EX counters{};
  counters.cb = sizeof counters;
  if (!K32GetProcessMemoryInfo(GetCurrentProcess(), reinterpret_cast<PROCESS_MEMORY_COUNTERS*>(&counters),
                               sizeof counters))
    return {};
  return counters;
}

void take_less(AvailableMemory& out, uint64_t limit, uint64_t used, const char* words) {
  const uint64_t left = limit > used ? limit - used : 0;
  if (left < out.bytes) out = {left, words};
}

}  // namespace

// What may still be committed, of the machine and of the job object that the process is in. What other processes of
// the job hold is not known, so its limit is less its own alone.
AvailableMemory available_memory() {
  AvailableMemory out;
  MEMORYSTATUSEX machine{};
  machine.dwLength = sizeof machine;
  if (GlobalMemoryStatusEx(&machine)) take_less(out, machine.ullAvailPageFile, 0, "what the machine has free");
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION job{};
  if (!QueryInformationJobObject(nullptr, JobObjectExtendedLimitInformation, &job, sizeof job, nullptr)) return out;
  const uint64_t used = process_memory().PrivateUsage;
  const DWORD flags = job.BasicLimitInformation.LimitFlags;
  if (flags & JOB_OBJECT_LIMIT_PROCESS_MEMORY)
    take_less(out, job.ProcessMemoryLimit, used, "the job object's limit of a process");
  if (flags & JOB_OBJECT_LIMIT_JOB_MEMORY) take_less(out, job.JobMemoryLimit, used, "the job object's limit");
  return out;
}

uint64_t resident_bytes() { return process_memory().WorkingSetSize; }
uint64_t peak_resident_bytes() { return process_memory().PeakWorkingSetSize; }

}  // namespace ups::platform
