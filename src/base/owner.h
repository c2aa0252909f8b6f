// The first member of every handle of a C API: which loaded copy of the library made it, and of which kind it is. A
// handle of another copy, one that was mixed up or one that was destroyed (as far as its memory can still be read) is
// told by it. Used by src/api and the extras.
#pragma once

namespace ups {

template <class Handle>
class Owner {
 public:
  Owner() : mark_(&here_) {}
  ~Owner() { mark_ = nullptr; }
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;
  bool is_ours() const { return mark_ == &here_; }

 private:
  const void* volatile mark_;  // volatile: the destructor's write counts, although nobody may read it any more
  static char here_;           // its address is that of this copy, as the library exports its functions alone
};
template <class Handle>
char Owner<Handle>::here_ = 0;

template <class T>
concept HandleType = requires(const T& handle) { handle.owner.is_ours(); };

// What is not ours stays: its maker alone knows how to.
template <HandleType T>
void destroy(T* handle) {
  if (handle && handle->owner.is_ours()) delete handle;
}

}  // namespace ups
