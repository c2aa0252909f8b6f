// See tally_queue.h. Who finds the queue empty while holding the sums gives them up in the same step.
#include "render/tally_queue.h"

#include <utility>

namespace ups {

namespace {

constexpr auto patience = std::chrono::milliseconds(5);  // between looks at a stop signal, which wakes nobody

}  // namespace

void TallyQueue::deliver(Delivery& delivery, const StopSignal& stop, const std::function<void()>& delivered) {
  const size_t bytes = delivery.tally.bytes();
  {
    std::unique_lock lock(mutex_);
    const auto has_room = [&] { return failure_ || waiting_.empty() || waiting_bytes_ + bytes <= most_bytes_; };
    while (!has_room() && !stop.is_set()) changed_.wait_for(lock, patience);
    if (failure_) std::rethrow_exception(failure_);
    waiting_.push_back(std::move(delivery));
    waiting_bytes_ += bytes;
    delivery = {};
    delivered();
    if (held_ || readers_ > 0) return;
    held_ = true;
  }
  add_all(true);
  check();
  const std::lock_guard lock(mutex_);
  delivery.tally = std::exchange(spare_, {});
}

void TallyQueue::check() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void TallyQueue::hold() {
  {
    std::unique_lock lock(mutex_);
    ++readers_;
    changed_.wait(lock, [&] { return !held_; });
    --readers_;
    held_ = true;
  }
  add_all(false);
}

// False, and with `release` the sums are given up, where nothing waits.
bool TallyQueue::take(Delivery& out, bool release) {
  const std::lock_guard lock(mutex_);
  if (!failure_ && !waiting_.empty()) {
    out = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= out.tally.bytes();
    return true;
  }
  if (release) {
    held_ = false;
    changed_.notify_all();
  }
  return false;
}

void TallyQueue::add_all(bool release) {
  Delivery next;
  while (take(next, release)) {
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
