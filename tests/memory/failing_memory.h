// Memory that runs out on demand: malloc and its kin, operator new, mmap and pthread_create of this process, of which
// chosen calls fail. Also keeps count of what the library itself holds. Needs glibc; no sanitizer beside it.
#pragma once
#include <cstddef>

namespace ups::test {

// Counts the calls of all threads from here on; fails those from number `first` (1 is the next one) on, `count` of them.
void fail_memory(long first, long count);
// No call fails any more. The number of calls since fail_memory().
long end_of_failing();

// Whether a thread can be started, beside all that.
void fail_threads(bool fail);

// Allocations made by the code of libups, of the extras, or of the C++ library for them, and not yet freed. From the
// first call of watch_library() on.
void watch_library();
long allocations_held();

// Bytes that the process has allocated, whoever did; the most that it had since begin_peak().
long bytes_allocated();
void begin_peak();
long peak_allocated();

}  // namespace ups::test
