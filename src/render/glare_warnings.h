// What a glare rating leaves out or stands on, a line each, or nothing. Called by the job.
#pragma once
#include <string>

#include "transport/glare.h"

namespace ups {

std::string glare_warnings(const Snapshot& scene, uint32_t observer_id, const SeenGlare& glare);

}  // namespace ups
