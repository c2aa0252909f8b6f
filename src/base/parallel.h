// Threads: oneTBB's arena of a context. Work is cut into blocks of fixed size, so results keyed by block do not depend
// on the number of threads.
#pragma once
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <functional>

namespace ups {

class ThreadPool {
 public:
  explicit ThreadPool(int thread_count)
      : count_(thread_count > 0 ? thread_count : tbb::this_task_arena::max_concurrency()), arena_(count_) {}
  int thread_count() const { return count_; }
  // body(block, begin, end) for every block of `grain` items; blocks run in any order.
  template <class Body>
  void for_blocks(size_t count, size_t grain, const Body& body) {
    const size_t blocks = (count + grain - 1) / grain;
    arena_.execute([&] {
      tbb::parallel_for(
          size_t(0), blocks, [&](size_t b) { body(b, b * grain, std::min(count, (b + 1) * grain)); },
          tbb::simple_partitioner{});
    });
  }

 private:
  int count_;
  tbb::task_arena arena_;
};

}  // namespace ups
