// Threads of the library as a guest's should be: they bear names, take no signals of the host, compute in the default
// floating-point environment; one that cannot start is an error with a message of its own.
#pragma once
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/floating_point.h"

namespace ups {

// Processors that this process may run on.
inline int processor_count() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0) return CPU_COUNT(&set);
  return int(std::max(1u, std::thread::hardware_concurrency()));  // more processors than the set holds
}

// While it lives this thread takes no signals, and a thread that it starts never will: it inherits the mask. Faults
// stay as they are: they are the thread's own, and the host's crash handler wants to see them.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS}) sigdelset(&all, fault);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

// Of the calling thread and those that it starts from now on: they run when nothing else wants the processor. There is no
// way back without privileges.
inline void lower_priority() { setpriority(PRIO_PROCESS, 0, 19); }  // of Linux, where 0 is the calling thread

// body() on a thread named "ups/<role>", cut to the 15 characters that Linux shows.
template <class Body>
std::thread start_thread(const std::string& role, Body body) {
  const SignalsBlocked blocked;
  try {
    return std::thread([name = ("ups/" + role).substr(0, 15), body = std::move(body)] {
      pthread_setname_np(pthread_self(), name.c_str());
      const DefaultFloatingPoint environment;
      body();
    });
  } catch (const std::system_error& e) {
    throw Error(UPS_ERROR_OUT_OF_MEMORY, std::string("a thread cannot be started: ") + e.code().message() +
                                             " (too little memory for its stack, or a limit of threads)");
  }
}

}  // namespace ups
