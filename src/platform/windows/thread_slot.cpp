// See thread_slot.h: fibre-local storage, as thread-local storage of Windows tells nobody that a thread ended.
#include "platform/thread_slot.h"

#include "platform/windows/system.h"

namespace ups::platform {

ThreadSlot::ThreadSlot(void (*release)(void*)) noexcept {
  const DWORD index = FlsAlloc(release);
  is_made_ = index != FLS_OUT_OF_INDEXES;
  key_ = index;
}

ThreadSlot::~ThreadSlot() {
  if (is_made_) FlsFree(DWORD(key_));
}

void* ThreadSlot::get() const noexcept { return is_made_ ? FlsGetValue(DWORD(key_)) : nullptr; }

bool ThreadSlot::set(const void* pointer) const noexcept {
  return is_made_ && FlsSetValue(DWORD(key_), const_cast<void*>(pointer)) != 0;
}

}  // namespace ups::platform
