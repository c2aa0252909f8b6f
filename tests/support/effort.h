// The environment variable UPS_TEST_EFFORT=low: renders of tests take a sixteenth of their iterations beyond eight, and no
// more where that is too noisy. Sanitizers run tests so (tests/sanitizers/run.sh): they look at the code that runs, not at
// what it reads.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace ups::test {

inline bool low_effort() {
  static const char* const effort = std::getenv("UPS_TEST_EFFORT");
  return effort && std::strcmp(effort, "low") == 0;
}

inline uint32_t with_effort(uint32_t iterations) {
  constexpr uint32_t enough = 8;  // for batches, checks and a second radius
  return low_effort() && iterations > enough ? enough + (iterations - enough) / 16 : iterations;
}

}  // namespace ups::test
