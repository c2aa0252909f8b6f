// Warnings that take a search of all surfaces, or rays of all emitters: found when somebody asks, and kept for later
// builds in which nothing of it has changed.
#pragma once
#include <string>
#include <vector>

#include "base/monitor.h"
#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

// Searches where nobody has yet. Any thread. Ends by Cancelled between two searches.
std::vector<std::string> searched_warnings(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor = nullptr);
// Those that were found by now.
std::vector<std::string> known_warnings(const Snapshot& scene);

}  // namespace ups
