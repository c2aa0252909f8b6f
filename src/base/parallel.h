// Threads: oneTBB's arena of a context. Work is cut into blocks of fixed size, so results keyed by block do not depend
// on the number of threads.
#pragma once
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace ups {

// oneTBB is built without the thread sanitizer, which so cannot see that blocks begin after the call that starts them and
// end before it returns: these say it. Blocks are not ordered among themselves, so races between them still show.
#ifdef __SANITIZE_THREAD__
extern "C" void __tsan_acquire(void* token);
extern "C" void __tsan_release(void* token);
inline char begin_token, end_token;
inline void happens_before(char& token) { __tsan_release(&token); }
inline void happens_after(char& token) { __tsan_acquire(&token); }
#define UPS_TSAN(statement) statement
#else
#define UPS_TSAN(statement)
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
    const auto run = [&](size_t b) {
      UPS_TSAN(happens_after(begin_token);)
      body(b, b * grain, std::min(count, (b + 1) * grain));
      UPS_TSAN(happens_before(end_token);)
    };
    UPS_TSAN(happens_before(begin_token);)
    arena_.execute([&] { tbb::parallel_for(size_t(0), blocks, run, tbb::simple_partitioner{}); });
    UPS_TSAN(happens_after(end_token);)
  }

 private:
  int count_;
  tbb::task_arena arena_;
};

}  // namespace ups
