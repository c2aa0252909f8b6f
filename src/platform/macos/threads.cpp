// See threads.h. Not compiled yet.
#include "platform/threads.h"

#include <pthread/qos.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "platform/posix/signals_blocked.h"

namespace ups::platform {

int processor_count() { return int(std::max(1u, std::thread::hardware_concurrency())); }

int64_t process_id() { return ::getpid(); }

// A thread's class of service is not inherited.
std::thread start_thread(const std::string& name, std::function<void()> body) {
  const SignalsBlocked blocked;
  return std::thread([name, service = qos_class_self(), run = std::move(body)] {
    pthread_setname_np(name.c_str());
    if (service == QOS_CLASS_BACKGROUND) lower_priority();
    run();
  });
}

void lower_priority() { pthread_set_qos_class_self_np(QOS_CLASS_BACKGROUND, 0); }

}  // namespace ups::platform
