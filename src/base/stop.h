// The wish to stop that work in progress looks up: someone cancelled, or its time is over. Once set it stays so.
#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>

namespace ups {

class StopSignal {
 public:
  using Clock = std::chrono::steady_clock;
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }  // from any thread
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  // By the thread that hands the work out, while none of it runs; never earlier than one that has passed.
  void set_deadline(Clock::time_point deadline) { deadline_ = deadline; }
  bool is_set() const { return is_cancelled() || Clock::now() >= deadline_; }
  // each(i) for i from 0 to count - 1, looking up in between. False: it was set, and not all were visited.
  template <class Each>
  bool for_each(size_t count, const Each& each) const {
    constexpr size_t between_looks = size_t(1) << 16;
    for (size_t i = 0; i < count;) {
      if (is_set()) return false;
      for (const size_t end = std::min(count, i + between_looks); i < end; ++i) each(i);
    }
    return true;
  }

 private:
  std::atomic<bool> cancelled_{false};
  Clock::time_point deadline_ = Clock::time_point::max();
};

}  // namespace ups
