// The environment variable UPS_TEST_EFFORT=low: renders of tests take a sixteenth of their iterations beyond eight and of
// their light paths beyond 1024, 2048 where the library would choose, and no more where that is too noisy. Sanitizers run
// tests so (tests/sanitizers/run.sh): they look at the code that runs, not at what it reads.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace ups::test {

inline bool low_effort() {
  static const char* const effort = std::getenv("UPS_TEST_EFFORT");
  return effort && std::strcmp(effort, "low") == 0;
}

inline uint32_t less_with_effort(uint32_t all, uint32_t enough) {
  return low_effort() && all > enough ? enough + (all - enough) / 16 : all;
}
// Eight are enough for batches, checks and a second radius, 1024 paths for several blocks of them.
inline uint32_t with_effort(uint32_t iterations) { return less_with_effort(iterations, 8); }
inline uint32_t paths_with_effort(uint32_t light_paths) {
  return light_paths == 0 && low_effort() ? 2048 : less_with_effort(light_paths, 1024);
}

}  // namespace ups::test
