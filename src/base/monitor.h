// How far long work is, whether it shall go on, and what it may take. One thread works, any others ask.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>

namespace ups {

// Thrown by the work itself once it was cancelled. No error: whoever cancelled catches it.
struct Cancelled {};

class Monitor {
 public:
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  void check() const {
    if (is_cancelled()) throw Cancelled();
  }
  // What the work may take beside what is there, bytes; 0: what the system has. Before it begins.
  void limit_memory(uint64_t bytes) { memory_limit_ = bytes; }
  uint64_t memory_limit() const { return memory_limit_; }
  float fraction() const { return fraction_.load(std::memory_order_relaxed); }
  // The work goes on to a part that ends at this fraction of the whole.
  void begin_part(float end) {
    check();
    begin_ = end_, end_ = end;
    report(0);
  }
  // Of the part; from any thread, and never back.
  void report(float share) {
    const float now = begin_ + (end_ - begin_) * std::clamp(share, 0.0f, 1.0f);
    float before = fraction();
    while (before < now && !fraction_.compare_exchange_weak(before, now, std::memory_order_relaxed)) {}
  }

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<float> fraction_{0};
  float begin_ = 0, end_ = 0;
  uint64_t memory_limit_ = 0;
};

}  // namespace ups
