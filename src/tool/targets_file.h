// A file of targets. Called by the render command.
#pragma once
#include <string>

#include "report/targets.h"
#include "tool/library.h"

namespace ups::tool {

// Throws Failure that names the file, the field, and what would be right.
Targets read_targets(const std::string& path);

}  // namespace ups::tool
