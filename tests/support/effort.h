// The environment variable UPS_TEST_EFFORT=low: renders of tests take next to an eighth of their iterations. Sanitizers
// run tests so (tests/sanitizers/run.sh): they look at the code that runs, not at the noise of what it reads, which
// many a test then finds too large.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace ups::test {

inline uint32_t with_effort(uint32_t iterations) {
  static const char* const effort = std::getenv("UPS_TEST_EFFORT");
  constexpr uint32_t enough = 8;  // for batches, checks and a second radius
  if (!effort || std::strcmp(effort, "low") != 0 || iterations <= enough) return iterations;
  return enough + (iterations - enough) / 16;
}

}  // namespace ups::test
