// Threads: oneTBB's arena of a context. Work is cut into blocks of fixed size, so results keyed by block do not depend
// on the number of threads.
#pragma once
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace ups {

#ifdef __SANITIZE_THREAD__
// oneTBB is built without the thread sanitizer, which so cannot see that tasks begin after the call that starts them
// and end before it returns. Threads of our own, which it can follow, stand in for it. Items are not ordered among
// themselves, so races between them show.
template <class Body, class... Partitioner>
void parallel_for(int threads, size_t count, const Body& body, const Partitioner&...) {
  std::atomic<size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    try {
      for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) body(i);
    } catch (...) {
      next.store(count, std::memory_order_relaxed);
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (size_t t = 1; t < std::min(count, size_t(threads)); ++t) others.emplace_back(work);
  work();
  for (std::thread& t : others) t.join();
  if (error) std::rethrow_exception(error);
}
#else
// body(i) for every i below count, in any order, on the threads of the arena this is called in.
template <class Body, class... Partitioner>
void parallel_for(int, size_t count, const Body& body, const Partitioner&... partitioner) {
  tbb::parallel_for(size_t(0), count, body, partitioner...);
}
#endif

class ThreadPool {
 public:
  explicit ThreadPool(int thread_count)
      : count_(thread_count > 0 ? thread_count : tbb::this_task_arena::max_concurrency()), arena_(count_) {}
  int thread_count() const { return count_; }
  // body(block, begin, end) for every block of `grain` items; blocks run in any order.
  template <class Body>
  void for_blocks(size_t count, size_t grain, const Body& body) {
    const size_t blocks = (count + grain - 1) / grain;
    const auto run = [&](size_t b) { body(b, b * grain, std::min(count, (b + 1) * grain)); };
#ifdef __SANITIZE_THREAD__
    parallel_for(count_, blocks, run);
#else
    arena_.execute([&] { parallel_for(count_, blocks, run, tbb::simple_partitioner{}); });
#endif
  }

 private:
  int count_;
  tbb::task_arena arena_;
};

}  // namespace ups
