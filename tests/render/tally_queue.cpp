// Who reads the sums holds nobody up, sees one iteration count throughout, and nothing that was delivered is lost.
#include "render/tally_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using namespace ups;

class Queue : public testing::Test {
 protected:
  TallyQueue::Delivery numbered(double number) const {
    TallyQueue::Delivery d;
    d.elapsed_s = number;
    return d;
  }
  void deliver(double number, const std::function<void()>& delivered = [] {}) {
    auto d = numbered(number);
    queue.deliver(d, stop, delivered);
  }
  std::vector<double> added;
  StopSignal stop;
  TallyQueue queue{[this](const TallyQueue::Delivery& d) {
                     if (d.elapsed_s < 0) throw std::runtime_error("negative");
                     added.push_back(d.elapsed_s);
                   },
                   1000 * IterationTally().bytes()};
};

// What was delivered is not delivered again: only the tally comes back, for its memory.
TEST_F(Queue, GivesBackNoCounts) {
  auto d = numbered(1);
  d.flux.light_paths = 7;
  d.has_iteration = false;
  queue.deliver(d, stop, [] {});
  EXPECT_EQ(d.flux.light_paths, 0u);
  EXPECT_TRUE(d.has_iteration);
  EXPECT_EQ(d.elapsed_s, 0);
}

// If delivery waited for the reader, this test would never end: the reader waits for the deliveries.
TEST_F(Queue, AReaderHoldsNobodyUp) {
  deliver(0);
  std::atomic<bool> reading{false}, delivered{false};
  size_t before = 0, after = 0;
  std::thread reader([&] {
    queue.read([&] {
      before = added.size();
      reading = true;
      while (!delivered) std::this_thread::yield();
      after = added.size();
    });
  });
  while (!reading) std::this_thread::yield();
  for (int i = 1; i <= 100; ++i) deliver(i);
  delivered = true;
  reader.join();
  EXPECT_EQ(before, 1u);
  EXPECT_EQ(after, 1u) << "the sums change while they are read";
  deliver(101);
  ASSERT_EQ(added.size(), 102u) << "with the next one what came meanwhile is added";
  for (int i = 0; i <= 101; ++i) EXPECT_EQ(added[i], i);
}

// Were a reader to go on until nothing waits, adding slower than the render delivers, it would return with the last.
TEST_F(Queue, AReaderAddsOnlyWhatWaited) {
  TallyQueue slow(
      [this](const TallyQueue::Delivery& d) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        added.push_back(d.elapsed_s);
      },
      8 * IterationTally().bytes());
  constexpr int most = 1000;
  std::atomic<bool> reading{false}, done{false};
  std::atomic<int> delivered{0};
  std::thread reader([&] {
    slow.read([&] {
      reading = true;
      while (delivered < 4) std::this_thread::yield();
    });
    done = true;
  });
  while (!reading) std::this_thread::yield();
  while (!done && delivered < most) {
    auto d = numbered(delivered);
    slow.deliver(d, stop, [] {});
    ++delivered;
  }
  reader.join();
  EXPECT_LT(delivered, most);
  slow.read([] {});
  ASSERT_EQ(added.size(), size_t(delivered));
  for (int i = 0; i < delivered; ++i) EXPECT_EQ(added[size_t(i)], i);
}

// The last delivery waits for no reader, and though none comes after it nothing is left: the reader adds it.
TEST_F(Queue, WhatCameLastIsAdded) {
  TallyQueue small([this](const TallyQueue::Delivery& d) { added.push_back(d.elapsed_s); }, 0);
  std::atomic<bool> reading{false}, delivered{false};
  std::thread reader([&] {
    small.read([&] {
      reading = true;
      while (!delivered) std::this_thread::yield();
    });
  });
  while (!reading) std::this_thread::yield();
  for (int i = 0; i < 2; ++i) {
    auto d = numbered(i);
    d.is_last = i == 1;
    small.deliver(d, stop, [] {});
  }
  delivered = true;
  reader.join();
  EXPECT_EQ(added, (std::vector<double>{0, 1}));
}

TEST_F(Queue, AReaderSeesAllThatWasDelivered) {
  std::atomic<int> delivered{0};
  std::atomic<bool> stopped{false};
  std::vector<std::thread> readers;
  for (int r = 0; r < 3; ++r)
    readers.emplace_back([&] {
      while (!stopped) {
        const int least = delivered;
        queue.read([&] { EXPECT_GE(int(added.size()), least); });
      }
    });
  for (int i = 0; i < 2000; ++i) {
    deliver(i);
    delivered = i + 1;
  }
  stopped = true;
  for (std::thread& r : readers) r.join();
  queue.read([] {});
  ASSERT_EQ(added.size(), 2000u);
  for (int i = 0; i < 2000; ++i) EXPECT_EQ(added[i], i);
}

// Who is told of a delivery, and reads at once, has it, however long the render's thread sleeps between two steps.
TEST_F(Queue, WhoIsToldOfADeliveryReadsIt) {
  std::atomic<bool> told{false};
  size_t found = 0;
  std::thread reader([&] {
    while (!told) std::this_thread::yield();
    queue.read([&] { found = added.size(); });
  });
  deliver(0, [&] {
    told = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  });
  reader.join();
  EXPECT_EQ(found, 1u);
}

TEST_F(Queue, WhatWaitsHasABound) {
  TallyQueue small([this](const TallyQueue::Delivery& d) { added.push_back(d.elapsed_s); },
                   2 * IterationTally().bytes());
  std::atomic<bool> reading{false};
  std::atomic<int> delivered{0};
  std::thread reader([&] {
    small.read([&] {
      reading = true;
      while (delivered < 2) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      EXPECT_EQ(delivered, 2) << "the third waits for the reader";
    });
  });
  while (!reading) std::this_thread::yield();
  for (int i = 0; i < 3; ++i) {
    auto d = numbered(i);
    small.deliver(d, stop, [] {});
    ++delivered;
  }
  reader.join();
  small.read([] {});
  EXPECT_EQ(added.size(), 3u);
}

TEST_F(Queue, FailuresReachTheRenderAndReaders) {
  EXPECT_THROW(deliver(-1), std::runtime_error);
  EXPECT_THROW(deliver(1), std::runtime_error) << "sums that lack an iteration are none";
  EXPECT_THROW(queue.read([] {}), std::runtime_error);
}

TEST_F(Queue, AReadersFailureIsItsOwn) {
  EXPECT_THROW(queue.read([] { throw std::logic_error("mine"); }), std::logic_error);
  deliver(1);
  EXPECT_EQ(added.size(), 1u);
}

}  // namespace
