// Which techniques a method stands for on a scene, and in words why. Called at commit (UPS_METHOD_AUTO) and by the job.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ups/ups_render.h"

namespace ups {

struct Snapshot;
struct TransportSettings;

struct MethodChoice {
  int32_t method;                     // UPS_METHOD_*, never AUTO
  uint32_t techniques;                // UPS_TECHNIQUE_*
  std::string text;                   // a line a technique: on or off, and why
  std::vector<std::string> warnings;  // light of the scene that the set cannot sample
};

// Throws Error INVALID_ARGUMENT where no technique is left.
MethodChoice choose_method(const Snapshot& scene, const ups_render_desc& desc);
TransportSettings settings_of(const ups_render_desc& desc, const MethodChoice& method);

}  // namespace ups
