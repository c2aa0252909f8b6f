// Which readings of a set are not what they seem: no path has found their light, or few, or a few bright ones made most
// of it. A line each, or nothing. Called by the job.
#pragma once
#include <string>

#include "render/accumulator.h"

namespace ups {

std::string reading_warnings(uint32_t set_id, const MeterSetReading& set);

}  // namespace ups
