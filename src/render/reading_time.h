// How long it takes to read what was found: a time limit keeps so much of it. Called by the job.
#pragma once
#include "scene/snapshot.h"
#include "transport/plan.h"

namespace ups {

// Seconds, about, as a slow machine takes; the first look at the errors shows how fast this one is.
struct ReadingTime {
  double look_s = 0, result_s = 0;
};

ReadingTime reading_time(const Snapshot& scene, const Plan& plan, uint32_t technique_edges);

}  // namespace ups
