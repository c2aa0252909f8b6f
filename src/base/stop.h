// The wish to stop that work in progress looks up: someone cancelled, or its time is over. Once set it stays so.
#pragma once
#include <atomic>
#include <chrono>

namespace ups {

class StopSignal {
 public:
  using Clock = std::chrono::steady_clock;
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }  // from any thread
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  // By the thread that hands the work out, while none of it runs; never earlier than one that has passed.
  void set_deadline(Clock::time_point deadline) { deadline_ = deadline; }
  bool is_set() const { return is_cancelled() || Clock::now() >= deadline_; }

 private:
  std::atomic<bool> cancelled_{false};
  Clock::time_point deadline_ = Clock::time_point::max();
};

}  // namespace ups
