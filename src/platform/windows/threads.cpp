// See threads.h.
#include "platform/threads.h"

#include <algorithm>
#include <bitset>
#include <new>
#include <utility>

#include "platform/windows/system.h"

namespace ups::platform {

namespace {

// Since Windows 10, version 1607.
void set_name(const std::string& name) {
  using SetDescription = HRESULT(WINAPI*)(HANDLE, PCWSTR);
  const HMODULE kernel = GetModuleHandleW(L"kernel32.dll");
  const auto set = reinterpret_cast<SetDescription>(
      reinterpret_cast<void*>(kernel ? GetProcAddress(kernel, "SetThreadDescription") : nullptr));
  try {
    if (set) set(GetCurrentThread(), native_path(name).c_str());
  } catch (const std::bad_alloc&) {  // it does without
  }
}

}  // namespace

int processor_count() {
  DWORD_PTR own = 0, all = 0;
  if (GetProcessAffinityMask(GetCurrentProcess(), &own, &all) && own != 0)
    return int(std::bitset<64>(own).count());
  return int(std::max(1u, std::thread::hardware_concurrency()));  // in several groups of processors
}

// There are no signals; a thread's priority is not inherited.
std::thread start_thread(const std::string& name, std::function<void()> body) {
  return std::thread([name, priority = GetThreadPriority(GetCurrentThread()), run = std::move(body)] {
    set_name(name);
    if (priority == THREAD_PRIORITY_IDLE) lower_priority();
    run();
  });
}

int64_t process_id() { return GetCurrentProcessId(); }

void lower_priority() { SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_IDLE); }

}  // namespace ups::platform
