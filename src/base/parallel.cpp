// See parallel.h: the workers and their loops, and the arena of oneTBB that they enter for Embree.
#include "base/parallel.h"

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <exception>
#include <string>

#include "base/thread.h"

namespace ups {

// ---- loops ----

// Lives on the stack of the thread that runs it.
struct ThreadPool::Loop {
  const size_t count;
  const Call body;
  std::atomic<size_t> next{0};
  int helpers = 0;           // workers within
  std::exception_ptr error;  // the first
  Loop* after = nullptr;

  bool open() const { return next.load(std::memory_order_relaxed) < count; }
};

ThreadPool::ThreadPool(int thread_count)
    : count_(thread_count > 0 ? thread_count : platform::processor_count()), arena_(std::make_unique<TaskArena>(count_)) {
  workers_.reserve(size_t(count_ - 1));
  try {
    for (int i = 1; i < count_; ++i)
      workers_.push_back(start_thread("worker " + std::to_string(i), [this] { work(); }));
  } catch (...) {
    end_workers();
    throw;
  }
}

ThreadPool::~ThreadPool() { end_workers(); }

void ThreadPool::end_workers() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  for (std::thread& t : workers_) t.join();
}

void ThreadPool::work() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    Loop* loop = first_;
    while (loop && !loop->open()) loop = loop->after;
    if (!loop) {
      wake_.wait(lock);
      continue;
    }
    ++loop->helpers;
    lock.unlock();
    take_part(*loop);
    lock.lock();
    if (--loop->helpers == 0) left_.notify_all();
  }
}

void ThreadPool::take_part(Loop& loop) {
  try {
    for (size_t i; (i = loop.next.fetch_add(1, std::memory_order_relaxed)) < loop.count;) loop.body(i);
  } catch (...) {
    loop.next.store(loop.count, std::memory_order_relaxed);
    const std::lock_guard lock(mutex_);
    if (!loop.error) loop.error = std::current_exception();
  }
}

// Loops may be nested and run on several threads at once: a thread waits only for helpers that are at work in its loop.
void ThreadPool::run(size_t count, Call body) {
  if (count <= 1 || workers_.empty()) {
    for (size_t i = 0; i < count; ++i) body(i);
    return;
  }
  Loop loop{count, body};
  {
    const std::lock_guard lock(mutex_);
    Loop** end = &first_;
    while (*end) end = &(*end)->after;
    *end = &loop;
  }
  wake_.notify_all();
  take_part(loop);
  std::unique_lock lock(mutex_);
  left_.wait(lock, [&] { return loop.helpers == 0; });
  Loop** link = &first_;
  while (*link != &loop) link = &(*link)->after;
  *link = loop.after;
  lock.unlock();
  if (loop.error) std::rethrow_exception(loop.error);
}

// ---- tasks of oneTBB ----

namespace {

// Threads that wait here work on the tasks of their arena until it opens.
class Gate {
 public:
  explicit Gate(size_t threads) { held_.reserve(threads); }
  bool is_open() const { return open_.load(); }
  void wait() {
    tbb::task_group group;
    tbb::task_handle holds = group.defer([] {});  // until it is destroyed there is something to wait for
    {
      const std::lock_guard lock(mutex_);
      if (open_.load()) return;
      held_.push_back(std::move(holds));
    }
    group.wait();
  }
  void open() {
    const std::lock_guard lock(mutex_);
    open_.store(true);
    held_.clear();
  }

 private:
  std::mutex mutex_;
  std::atomic<bool> open_{false};
  std::vector<tbb::task_handle> held_;
};

}  // namespace

// All its slots are for threads that enter it, so oneTBB makes no threads for it.
struct ThreadPool::TaskArena {
  explicit TaskArena(int threads) : arena(threads, unsigned(threads)), ready(size_t(threads)) {}

  // Enters it and runs body.
  template <class Body>
  void execute(const Body& body) {
    const TrapsMasked masked;  // tasks are Embree's
    arena.execute([&] {
      make_ready(size_t(tbb::this_task_arena::current_thread_index()));
      body();
    });
  }

  std::mutex one_at_a_time;  // more threads than slots would have to wait, and oneTBB would make a thread for them

 private:
  // oneTBB, when it has no memory to store a task, throws but goes on counting it, and whoever waits for it waits for
  // good. A slot's store grows and never shrinks: tasks of no effect fill it before those that matter.
  void make_ready(size_t slot) {
    if (slot >= ready.size() || ready[slot]) return;
    constexpr int more_than_embree_stores = 256;  // a few for each level of nested loops
    auto group = std::make_unique<tbb::task_group>();
    try {
      for (int i = 0; i < more_than_embree_stores; ++i) group->run([] {});
      group->wait();
    } catch (...) {
      group.release();  // its destructor would wait for good
      throw;
    }
    ready[slot] = true;
  }

  tbb::task_arena arena;
  std::vector<std::atomic<bool>> ready;  // by slot; a slot has one thread at a time
};

void ThreadPool::run_tasks(Call body) {
  const std::lock_guard lock(arena_->one_at_a_time);
  if (count_ == 1) return arena_->execute([&] { body(0); });
  Gate gate{size_t(count_)};
  for_blocks(size_t(count_), 1, [&](size_t block, size_t, size_t) {
    if (block == 0) {
      const std::unique_ptr<Gate, void (*)(Gate*)> opens_it(&gate, [](Gate* g) { g->open(); });
      arena_->execute([&] { body(0); });
    } else if (!gate.is_open()) {
      try {
        arena_->execute([&] { gate.wait(); });
      } catch (...) {
        // Without memory for this thread to help with, the others do it.
      }
    }
  });
}

}  // namespace ups
