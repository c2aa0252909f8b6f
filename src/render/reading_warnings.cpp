// See reading_warnings.h.
#include "render/reading_warnings.h"

#include <algorithm>

namespace ups {

namespace {

// Of exact light, the share that what was not found by chance may be without a word.
constexpr double negligible = 0.01;

std::string listed(const std::vector<size_t>& meters) {
  constexpr size_t most = 5;
  std::string text;
  for (size_t i = 0; i < std::min(most, meters.size()); ++i) text += (i ? ", " : "") + std::to_string(meters[i]);
  return meters.size() > most ? text + ", ..." : text;
}

template <class Holds>
std::string line(uint32_t set_id, const MeterSetReading& set, const Holds& holds, const char* what) {
  std::vector<size_t> meters;
  for (size_t m = 0; m < set.meters.size(); ++m)
    if (holds(set.flags[m], set.meters[m])) meters.push_back(m);
  if (meters.empty()) return {};
  return "meters " + std::to_string(set_id) + ": " + std::to_string(meters.size()) + " of " +
         std::to_string(set.meters.size()) + " (indices " + listed(meters) + ") " + what + "\n";
}

}  // namespace

std::string reading_warnings(uint32_t set_id, const MeterSetReading& set) {
  return line(
             set_id, set,
             [](uint32_t flags, const ups_meter_reading& r) {
               return (flags & UPS_READING_FEW_PATHS) && r.error_bound_lx > negligible * double(r.illuminance_lx);
             },
             "have light that no path or too few have found: their standard errors are -1, their bounds those of the "
             "rule of three") +
         line(
             set_id, set,
             [](uint32_t flags, const ups_meter_reading&) {
               return (flags & (UPS_READING_SINGLE_PATH | UPS_READING_HEAVY_TAIL)) != 0;
             },
             "have unreliable intervals: a few bright paths made much of what was found; see "
             "ups_result_read_meter_flags");
}

}  // namespace ups
