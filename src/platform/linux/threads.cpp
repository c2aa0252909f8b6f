// See threads.h.
#include "platform/threads.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "platform/posix/signals_blocked.h"

namespace ups::platform {

int processor_count() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0) return CPU_COUNT(&set);
  return int(std::max(1u, std::thread::hardware_concurrency()));  // more processors than the set holds
}

int64_t process_id() { return ::getpid(); }

std::thread start_thread(const std::string& name, std::function<void()> body) {
  constexpr size_t most_characters = 15;  // that are shown
  const SignalsBlocked blocked;
  return std::thread([shown = name.substr(0, most_characters), run = std::move(body)] {
    pthread_setname_np(pthread_self(), shown.c_str());
    run();
  });
}

void lower_priority() { setpriority(PRIO_PROCESS, 0, 19); }  // of Linux, where 0 is the calling thread

}  // namespace ups::platform
