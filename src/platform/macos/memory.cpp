// See memory.h. Not compiled yet.
#include "platform/memory.h"

#include <mach/mach.h>
#include <sys/resource.h>

namespace ups::platform {

// Nothing tells how far the swap file may still grow: what is free, and what is dropped or written out first.
AvailableMemory available_memory() {
  const host_t host = mach_host_self();
  vm_statistics64_data_t pages{};
  mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
  vm_size_t page = 0;
  if (host_statistics64(host, HOST_VM_INFO64, reinterpret_cast<host_info64_t>(&pages), &count) != KERN_SUCCESS ||
      host_page_size(host, &page) != KERN_SUCCESS)
    return {};
  const uint64_t free = uint64_t(pages.free_count) + pages.inactive_count + pages.purgeable_count;
  return {free * page, "what the machine has free"};
}

uint64_t resident_bytes() {
  mach_task_basic_info_data_t info{};
  mach_msg_type_number_t count = MACH_TASK_BASIC_INFO_COUNT;
  const auto to = reinterpret_cast<task_info_t>(&info);
  return task_info(mach_task_self(), MACH_TASK_BASIC_INFO, to, &count) == KERN_SUCCESS ? info.resident_size : 0;
}

uint64_t peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return uint64_t(usage.ru_maxrss);
}

}  // namespace ups::platform
