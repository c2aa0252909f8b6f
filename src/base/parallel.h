// Threads of a context. Work is cut into blocks of fixed size, so results keyed by block do not depend on the number of
// threads. A loop takes no memory, so none can fail for the want of it.
#pragma once
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace ups {

class ThreadPool {
 public:
  // The thread that calls counts as one of them. 0: as many as there are processors.
  explicit ThreadPool(int thread_count);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  int thread_count() const { return count_; }

  // body(block, begin, end) for every block of `grain` items; blocks run in any order. Where one throws, those that no
  // thread has begun are left out and one of the exceptions is thrown on.
  template <class Body>
  void for_blocks(size_t count, size_t grain, const Body& body) {
    const auto block = [&](size_t b) { body(b, b * grain, (b + 1) * grain < count ? (b + 1) * grain : count); };
    run((count + grain - 1) / grain, Call(block));
  }
  // body() on the calling thread or another, with the others there for the tasks of oneTBB that it makes: for Embree,
  // which builds with them. oneTBB's own threads stay out: they come when it pleases, by allocations that may fail.
  template <class Body>
  void run_tasks(const Body& body) {
    const auto once = [&](size_t) { body(); };
    run_tasks(Call(once));
  }

 private:
  // What a loop calls with each index; refers to its argument.
  struct Call {
    template <class Body>
    explicit Call(const Body& body)
        : body_(&body), call_([](const void* b, size_t i) { (*static_cast<const Body*>(b))(i); }) {}
    void operator()(size_t i) const { call_(body_, i); }

   private:
    const void* body_;
    void (*call_)(const void*, size_t);
  };
  struct Loop;
  struct TaskArena;
  void run(size_t count, Call body);
  void run_tasks(Call body);
  void take_part(Loop& loop);
  void work();
  void end_workers();

  const int count_;
  std::mutex mutex_;  // guards what follows, and the loops
  std::condition_variable wake_, left_;
  Loop* first_ = nullptr;  // open loops, oldest first
  bool ending_ = false;
  std::unique_ptr<TaskArena> arena_;
  std::vector<std::thread> workers_;
};

// body(i) for every i below count, in any order.
template <class Body>
void parallel_for(ThreadPool& pool, size_t count, const Body& body) {
  pool.for_blocks(count, 1, [&](size_t i, size_t, size_t) { body(i); });
}

}  // namespace ups
