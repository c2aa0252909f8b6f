// The threads of a job: the context's, or its own where they are to be fewer or humbler; and the error that one ends with.
// Asked by job.cpp and commit.cpp.
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <string>

#include "base/error.h"
#include "base/parallel.h"
#include "base/thread.h"
#include "ups/ups_scene.h"

namespace ups {

inline void check_priority(ups_priority priority) {
  if (priority != UPS_PRIORITY_NORMAL && priority != UPS_PRIORITY_LOW)
    fail_argument("priority: " + std::to_string(priority) + " is not a UPS_PRIORITY_* value");
}

struct JobThreads {
  std::shared_ptr<ThreadPool> pool;  // the context's
  uint32_t limit = 0;                // 0: none
  ups_priority priority = UPS_PRIORITY_NORMAL;

  // On the job's own thread, which hands its priority down.
  std::shared_ptr<ThreadPool> take() const {
    const int all = pool->thread_count(), most = int(std::min<uint32_t>(limit, uint32_t(all)));
    const bool low = priority == UPS_PRIORITY_LOW;
    if (low) platform::lower_priority();
    if (!low && (most == 0 || most == all)) return pool;
    return std::make_shared<ThreadPool>(most > 0 ? most : all);
  }
};

struct JobError {
  ups_status status = UPS_OK;
  std::string message;

  // What a catch block is in, where memory is gone, too.
  void keep() {
    tell_exception([this](ups_status code, const char* text) {
      status = code;
      try {
        message = text;
      } catch (const std::bad_alloc&) {
        message = "out of memory";  // short: a string that allocates nothing
      }
    });
  }
};

}  // namespace ups
