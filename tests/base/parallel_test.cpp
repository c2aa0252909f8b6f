// The threads of a context: each block once, exceptions, loops within loops and from several threads at once, and the
// tasks of oneTBB that they work on.
#include "base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace ups {
namespace {

TEST(ThreadPool, EveryItemOnce) {
  for (const int threads : {1, 2, 5}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.thread_count(), threads);
    for (const size_t count : {0, 1, 7, 1000}) {
      std::vector<int> visits(count);
      pool.for_blocks(count, 7, [&](size_t block, size_t begin, size_t end) {
        EXPECT_EQ(begin, 7 * block);
        for (size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads";
    }
  }
}

TEST(ThreadPool, AnExceptionEndsTheLoopAndIsThrownOn) {
  for (const int threads : {1, 4}) {
    ThreadPool pool(threads);
    EXPECT_THROW(parallel_for(pool, 100, [](size_t i) {
                   if (i % 10 == 3) throw std::runtime_error("three");
                 }),
                 std::runtime_error);
    std::atomic<int> after{0};
    parallel_for(pool, 100, [&](size_t) { ++after; });
    EXPECT_EQ(after, 100);
  }
}

TEST(ThreadPool, LoopsWithinLoopsFromSeveralThreads) {
  ThreadPool pool(3);
  std::atomic<int> count{0};
  const auto work = [&] {
    for (int repeat = 0; repeat < 20; ++repeat)
      parallel_for(pool, 8, [&](size_t) { parallel_for(pool, 8, [&](size_t) { ++count; }); });
  };
  std::thread first(work), second(work);
  first.join();
  second.join();
  EXPECT_EQ(count, 2 * 20 * 64);
}

TEST(ThreadPool, TasksRunOnItsThreadsAndExceptionsLeave) {
  // Counts are atomic as the thread sanitizer, without which oneTBB is built, misses how its tasks synchronise.
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads);
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::vector<std::atomic<int>> visits(5000);
      std::atomic<int> calls{0};
      pool.run_tasks([&] {
        ++calls;
        tbb::parallel_for(size_t(0), visits.size(), [&](size_t i) { ++visits[i]; });
      });
      EXPECT_EQ(calls, 1);
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), 5000);
    }
    EXPECT_THROW(pool.run_tasks([] { throw std::runtime_error("build"); }), std::runtime_error);
    EXPECT_THROW(pool.run_tasks([] {
      tbb::parallel_for(0, 1000, [](int i) {
        if (i == 777) throw std::runtime_error("task");
      });
    }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace ups
