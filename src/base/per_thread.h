// Storage that each thread has of its own and uses again: a thread_local for what has a destructor. Such a thread_local
// needs memory at its first use in a thread and ends the process where there is none; this throws std::bad_alloc.
#pragma once
#include <pthread.h>

#include <memory>
#include <new>

namespace ups {

// For statics: a thread's object lives as long as the thread.
template <class T>
class PerThread {
 public:
  PerThread() : made_(pthread_key_create(&key_, [](void* kept) { delete static_cast<T*>(kept); }) == 0) {}
  PerThread(const PerThread&) = delete;
  PerThread& operator=(const PerThread&) = delete;

  T& get() const {
    if (!made_) throw std::bad_alloc();
    if (void* kept = pthread_getspecific(key_)) return *static_cast<T*>(kept);
    auto fresh = std::make_unique<T>();
    if (pthread_setspecific(key_, fresh.get()) != 0) throw std::bad_alloc();
    return *fresh.release();
  }

 private:
  pthread_key_t key_;
  const bool made_;
};

}  // namespace ups
