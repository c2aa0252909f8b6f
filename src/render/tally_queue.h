// Between a render, which finds one tally after the other, and the sums that these are added to and that others read.
// A reader takes as long as it likes, and the render never waits for it, nor does anyone who does not need the sums.
// Who takes the sums adds what waits: a reader what was delivered before, the render all. The last delivery waits for
// nobody: a reader that holds the sums then adds what has come meanwhile.
#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

#include "base/stop.h"
#include "transport/tally.h"

namespace ups {

class TallyQueue {
 public:
  struct Delivery {
    IterationTally tally;
    bool has_iteration = true;  // false: tally is empty
    bool is_last = false;       // nothing comes after it
    WorkCounts flux;            // of paths that only book flux
    double elapsed_s = 0;
  };
  static constexpr size_t default_bytes = size_t(256) << 20;
  // add: called by one thread at a time, in the order of delivery. most_bytes: of deliveries that wait for a reader.
  explicit TallyQueue(std::function<void(const Delivery&)> add, size_t most_bytes = default_bytes)
      : add_(std::move(add)), most_bytes_(most_bytes) {}
  void set_most_bytes(size_t bytes) { most_bytes_ = bytes; }  // before the first delivery

  // Waits only where too much waits for a reader, until `stop` is set; never with the last one. `delivery` becomes one
  // whose memory can be used again. Throws what `add` threw in any thread. delivered: called as soon as every later
  // read has the delivery, and before another thread can read it; must not call the queue.
  void deliver(Delivery& delivery, const StopSignal& stop, const std::function<void()>& delivered);
  // read(): with the sums held, of all that was delivered before the call. Throws what `add` threw.
  template <class Read>
  auto read(const Read& read) {
    hold();
    const Holder holder{*this};
    check();
    return read();
  }

 private:
  struct Holder {
    TallyQueue& queue;
    ~Holder() { queue.release(); }
  };
  void hold();
  void release();
  void check();
  bool take(Delivery& out);  // as give_up(), with the mutex locked
  void give_up();
  void add(size_t most);

  const std::function<void(const Delivery&)> add_;
  size_t most_bytes_;
  std::mutex mutex_;  // guards all below; never held for long
  std::condition_variable changed_;
  std::deque<Delivery> waiting_;
  size_t waiting_bytes_ = 0;
  IterationTally spare_;
  bool held_ = false;
  bool has_ended_ = false;  // the last delivery came
  int readers_ = 0;  // that wait for the sums: they are next, and add what waits then
  std::exception_ptr failure_;
};

}  // namespace ups
