// Warnings that take a search of all surfaces, or rays of all emitters: found when somebody asks, and kept for later
// builds in which nothing of it has changed.
#pragma once
#include <string>
#include <vector>

#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

// Searches where nobody has yet. Any thread.
std::vector<std::string> searched_warnings(const Snapshot& scene, ThreadPool& pool);
// Those that were found by now.
std::vector<std::string> known_warnings(const Snapshot& scene);

}  // namespace ups
