// Samples that were left out because they were not finite: how many by each technique, and where the first was.
#pragma once
#include <string>

#include "transport/integrator.h"

namespace ups {

// A line each; empty where there are none. The same text for any number of threads.
std::string dropped_text(const Integrator& integrator, const WorkCounts& work);

}  // namespace ups
