// How many processors this process may run on: a context of more threads has no more.
#pragma once
#include <sched.h>

namespace ups::test {

inline int processors() {
  cpu_set_t set;
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace ups::test
