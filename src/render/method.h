// Which techniques a method stands for on a scene, and in words why. Called at commit (UPS_METHOD_AUTO) and by the job.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ups/ups_render.h"

namespace ups {

struct Snapshot;
struct TransportSettings;
class Integrator;

struct MethodChoice {
  int32_t method;                     // UPS_METHOD_*, never AUTO
  uint32_t techniques;                // UPS_TECHNIQUE_*
  std::string text;                   // a line a technique: on or off, and why
  std::vector<std::string> warnings;  // light of the scene that the set cannot sample
  bool selects = false;               // a pilot chooses among `possible`: the method says where it starts from
  uint32_t possible = 0;
};

// Throws Error INVALID_ARGUMENT where no technique is left.
MethodChoice choose_method(const Snapshot& scene, const ups_render_desc& desc);
TransportSettings settings_of(const ups_render_desc& desc, const MethodChoice& method);
// What the pilot chose, in place of where it started from.
void tell_selection(const Integrator& integrator, MethodChoice& method);

}  // namespace ups
