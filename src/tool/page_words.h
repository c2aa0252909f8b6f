// What the program puts onto its page beside what was found: when, and by which command. Called by the render command.
#pragma once
#include <string>
#include <vector>

#include "ups/ups_render.h"

namespace ups::tool {

// The time now, UTC; of SOURCE_DATE_EPOCH where that is set.
std::string date_text();
// A shell's words that render the same again: the program's arguments without limits, with these iterations and seed.
std::string command_text(const std::vector<std::string>& arguments, const ups_result_info& info);
// Those that trace a sample of that render again.
std::string replay_text(const std::vector<std::string>& arguments, const std::string& scene, const std::string& sample);

}  // namespace ups::tool
