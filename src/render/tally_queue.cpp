// See tally_queue.h. One thread delivers: while that adds, and after the last delivery, nothing new comes.
#include "render/tally_queue.h"

#include <chrono>
#include <cstdint>
#include <utility>

namespace ups {

namespace {

constexpr auto patience = std::chrono::milliseconds(5);  // between looks at a stop signal, which wakes nobody

}  // namespace

void TallyQueue::deliver(Delivery& delivery, const StopSignal& stop, const std::function<void()>& delivered) {
  const size_t bytes = delivery.tally.bytes();
  {
    std::unique_lock lock(mutex_);
    const auto is_free = [&] { return !held_ && readers_ == 0; };  // all is added at once
    const auto has_room = [&] {
      return failure_ || waiting_.empty() || waiting_bytes_ + bytes <= most_bytes_ || is_free() || delivery.is_last;
    };
    while (!has_room() && !stop.is_set()) changed_.wait_for(lock, patience);
    if (failure_) std::rethrow_exception(failure_);
    waiting_.push_back(std::move(delivery));
    has_ended_ = waiting_.back().is_last;
    waiting_bytes_ += bytes;
    delivery = {};
    delivered();
    if (!is_free()) return;
    held_ = true;
  }
  add(SIZE_MAX);
  const std::lock_guard lock(mutex_);
  give_up();
  if (failure_) std::rethrow_exception(failure_);
  delivery.tally = std::exchange(spare_, {});
}

void TallyQueue::check() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void TallyQueue::hold() {
  size_t waiting;
  {
    std::unique_lock lock(mutex_);
    ++readers_;
    changed_.wait(lock, [&] { return !held_; });
    --readers_;
    held_ = true;
    waiting = waiting_.size();
  }
  add(waiting);
}

// By a reader: what came meanwhile is for who takes the sums next, and after the last delivery for this one.
void TallyQueue::release() {
  std::unique_lock lock(mutex_);
  if (has_ended_) {
    lock.unlock();
    add(SIZE_MAX);
    lock.lock();
  }
  give_up();
}

void TallyQueue::give_up() {
  held_ = false;
  changed_.notify_all();
}

bool TallyQueue::take(Delivery& out) {
  if (failure_ || waiting_.empty()) return false;
  out = std::move(waiting_.front());
  waiting_.pop_front();
  waiting_bytes_ -= out.tally.bytes();
  return true;
}

void TallyQueue::add(size_t most) {
  Delivery next;
  for (size_t i = 0; i < most; ++i) {
    {
      const std::lock_guard lock(mutex_);
      if (!take(next)) return;
    }
    std::exception_ptr failure;
    try {
      add_(next);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (failure)
      failure_ = failure;
    else
      spare_ = std::move(next.tally);
    changed_.notify_all();
  }
}

}  // namespace ups
