// A pointer that each thread has of its own. Not thread_local, whose first use in a thread may need memory and ends the
// process where there is none: this says so.
#pragma once
#include <cstdint>

namespace ups::platform {

class ThreadSlot {
 public:
  // release: called with a thread's pointer, where it is not null, when the thread ends.
  explicit ThreadSlot(void (*release)(void*)) noexcept;
  ~ThreadSlot();
  ThreadSlot(const ThreadSlot&) = delete;
  ThreadSlot& operator=(const ThreadSlot&) = delete;

  void* get() const noexcept;                    // null before the first set()
  bool set(const void* pointer) const noexcept;  // false: no memory, or no slot: a process has only so many

 private:
  uintptr_t key_ = 0;
  bool is_made_;
};

}  // namespace ups::platform
