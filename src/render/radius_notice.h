// Says where merge radii have come down to the least that floats resolve. Asked by render/job for each result.
#pragma once
#include <cstdint>
#include <string>

#include "transport/integrator.h"

namespace ups {

// A line for each sensor whose radii, or some of them, stood there in the last of so many iterations.
std::string radius_notice(const Integrator& integrator, uint32_t iterations);

}  // namespace ups
