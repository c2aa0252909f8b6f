// A sample traced again, as the C API tells it: vertices, contributions, and a text for people. Called by the job.
#pragma once
#include <string>
#include <vector>

#include "transport/integrator.h"
#include "ups/ups_replay.h"

namespace ups {

struct PathReplay {
  ups_path_info info{};
  std::vector<ups_path_vertex> vertices;            // instances by their numbers
  std::vector<ups_path_contribution> contributions;  // sources by theirs
  std::string text;
};

// Throws Error INVALID_ARGUMENT where the integrator's render traces no such path; sensor by its number.
PathReplay replay(Integrator& integrator, const ups_sample& sample, const StopSignal& stop);

}  // namespace ups
