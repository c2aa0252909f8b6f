// The first member of every handle of a C API: which loaded copy of the library made it, and of which kind it is. A
// handle of another copy, one that was mixed up or one that was destroyed (as far as its memory can still be read) is
// told by it. Used by src/api and the extras.
#pragma once
#include "platform/threads.h"

namespace ups {

template <class Handle>
class Owner {
 public:
  Owner() : mark_(&here_) {}
  ~Owner() { mark_ = nullptr; }
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;
  bool is_ours() const { return mark_ == &here_; }
  bool is_of_this_process() const { return process_ == platform::process_id(); }

 private:
  const int64_t process_ = platform::process_id();
  const void* volatile mark_;  // volatile: the destructor's write counts, although nobody may read it any more
  static char here_;           // its address is that of this copy, as the library exports its functions alone
};
template <class Handle>
char Owner<Handle>::here_ = 0;

template <class T>
concept HandleType = requires(const T& handle) { handle.owner.is_ours(); };

// What is not ours stays: its maker alone knows how to. So does what a process has from before it was forked: the
// threads that would have to end, or hold a lock, are its parent's.
template <HandleType T>
void destroy(T* handle) {
  if (handle && handle->owner.is_ours() && handle->owner.is_of_this_process()) delete handle;
}

}  // namespace ups
