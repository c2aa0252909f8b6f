// What arrays that grow as a render goes on may take together, on all threads: light paths' vertices and what they bring.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ups {

class MemoryBudget {
 public:
  // While nobody takes any. advice: what would be right where it does not suffice.
  void set(size_t most, std::string advice) { most_ = most, advice_ = std::move(advice); }
  // Throws Error OUT_OF_MEMORY where there is too little left.
  void take(size_t bytes) {
    const size_t used = used_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
    raise(wanted_, used);
    if (used <= most_) return raise(peak_, used);
    give_back(bytes);
    throw Error(UPS_ERROR_OUT_OF_MEMORY, "the light paths of an iteration want " + in_bytes(used) + " or more, " +
                                             in_bytes(most_) + " are left for them" + advice_);
  }
  void give_back(size_t bytes) { used_.fetch_sub(bytes, std::memory_order_relaxed); }
  size_t peak() const { return peak_.load(std::memory_order_relaxed); }  // taken so far, at most at a time
  size_t wanted() const { return wanted_.load(std::memory_order_relaxed); }  // the same with what was refused
  // "20 kB", "500 MB", "24 GB".
  static std::string in_bytes(double bytes) {
    const char* const units[] = {" kB", " MB", " GB"};
    double unit = 1e3;
    size_t i = 0;
    while (i < 2 && bytes >= 1e4 * unit) unit *= 1e3, ++i;
    return std::to_string(uint64_t(bytes / unit + 0.5)) + units[i];
  }

 private:
  static void raise(std::atomic<size_t>& most, size_t value) {
    size_t before = most.load(std::memory_order_relaxed);
    while (value > before && !most.compare_exchange_weak(before, value, std::memory_order_relaxed)) {}
  }
  std::atomic<size_t> used_{0}, peak_{0}, wanted_{0};
  size_t most_ = SIZE_MAX;
  std::string advice_;
};

// What one owner has taken; gives it back with the arrays that it stands beside. Without a budget it counts nothing.
class MemoryShare {
 public:
  MemoryShare() = default;
  explicit MemoryShare(MemoryBudget* budget) : budget_(budget) {}
  MemoryShare(MemoryShare&& o) noexcept : budget_(o.budget_), held_(std::exchange(o.held_, 0)) {}
  MemoryShare& operator=(MemoryShare&& o) noexcept {
    std::swap(budget_, o.budget_), std::swap(held_, o.held_);
    return *this;
  }
  ~MemoryShare() {
    if (budget_) budget_->give_back(held_);
  }
  void take(size_t bytes) {
    if (!budget_) return;
    budget_->take(bytes);
    held_ += bytes;
  }
  // The array grows as std::vector does: to twice its size, the old one beside the new one until it is copied.
  template <class T>
  void push_back(std::vector<T>& to, const T& value) {
    if (!budget_ || to.size() < to.capacity()) return to.push_back(value);
    const size_t old = to.capacity() * sizeof(T);
    take(std::max(sizeof(T), 2 * old));
    to.push_back(value);
    held_ -= old;
    budget_->give_back(old);
  }

 private:
  MemoryBudget* budget_ = nullptr;
  size_t held_ = 0;
};

}  // namespace ups
