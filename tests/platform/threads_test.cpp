// Threads of a guest, and what each has of its own.
#include "platform/threads.h"

#include <gtest/gtest.h>

#include <atomic>

#include "platform/thread_slot.h"

#ifdef __linux__
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#endif

namespace ups::platform {
namespace {

TEST(Threads, Run) {
  EXPECT_GE(processor_count(), 1);
  std::atomic<bool> ran = false;
  std::thread thread = start_thread("ups/a name that is longer than is shown", [&] { ran = true; });
  thread.join();
  EXPECT_TRUE(ran);
}

#ifdef __linux__
TEST(Threads, NameSignalsAndPriority) {
  const auto blocks = [](int signal) {
    sigset_t mask;
    pthread_sigmask(SIG_SETMASK, nullptr, &mask);
    return sigismember(&mask, signal) == 1;
  };
  start_thread("ups/worker 12345678", [&] {
    char name[16];
    ASSERT_EQ(pthread_getname_np(pthread_self(), name, sizeof name), 0);
    EXPECT_STREQ(name, "ups/worker 1234");
    EXPECT_TRUE(blocks(SIGINT) && blocks(SIGTERM));
    EXPECT_FALSE(blocks(SIGSEGV) || blocks(SIGFPE));
    lower_priority();
    start_thread("ups/child", [] { EXPECT_EQ(getpriority(PRIO_PROCESS, 0), 19); }).join();
  }).join();
  EXPECT_FALSE(blocks(SIGINT)) << "of the thread that starts others";
  EXPECT_LT(getpriority(PRIO_PROCESS, 0), 19);
}
#endif

std::atomic<int> released = 0;

TEST(Threads, SlotsAreEachThreadsOwn) {
  const ThreadSlot slot([](void* pointer) { released += *static_cast<int*>(pointer); });
  EXPECT_EQ(slot.get(), nullptr);
  int here = 1, there = 10;
  EXPECT_TRUE(slot.set(&here));
  start_thread("ups/other", [&] {
    EXPECT_EQ(slot.get(), nullptr);
    EXPECT_TRUE(slot.set(&there));
    EXPECT_EQ(slot.get(), &there);
  }).join();
  start_thread("ups/without", [&] { EXPECT_EQ(slot.get(), nullptr); }).join();
  EXPECT_EQ(released, 10);
  EXPECT_EQ(slot.get(), &here);
  EXPECT_TRUE(slot.set(nullptr));
}

}  // namespace
}  // namespace ups::platform
