// See thread_slot.h.
#include "platform/thread_slot.h"

#include <pthread.h>

namespace ups::platform {

ThreadSlot::ThreadSlot(void (*release)(void*)) noexcept {
  pthread_key_t key{};
  is_made_ = pthread_key_create(&key, release) == 0;
  key_ = uintptr_t(key);
}

ThreadSlot::~ThreadSlot() {
  if (is_made_) pthread_key_delete(pthread_key_t(key_));
}

void* ThreadSlot::get() const noexcept {
  return is_made_ ? pthread_getspecific(pthread_key_t(key_)) : nullptr;
}

// Fails where the C library has no memory for a table of many keys.
bool ThreadSlot::set(const void* pointer) const noexcept {
  return is_made_ && pthread_setspecific(pthread_key_t(key_), pointer) == 0;
}

}  // namespace ups::platform
