// Which techniques a method stands for on a scene, and in words why. Called at commit (UPS_METHOD_AUTO) and by the job.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace ups {

struct Snapshot;

struct MethodChoice {
  int32_t method;                     // UPS_METHOD_*, never AUTO
  uint32_t techniques;                // UPS_TECHNIQUE_*
  std::string text;                   // a line a technique: on or off, and why
  std::vector<std::string> warnings;  // light of the scene that the set cannot sample
};

// allowed: UPS_TECHNIQUE_* mask; 0: all. Throws Error: UNSUPPORTED for methods that are not built, INVALID_ARGUMENT where
// nothing is left.
MethodChoice choose_method(const Snapshot& scene, int32_t requested, uint32_t allowed);

}  // namespace ups
