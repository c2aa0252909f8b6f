// The environment variable UPS_TEST_TRACE=1: what each render of a test costs, and what noise it reaches, beside the
// limit that the test sets: more than a test needs is time that every run of all tests takes.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "result.h"

namespace ups::test {

inline bool traces_renders() { return std::getenv("UPS_TEST_TRACE") != nullptr; }

// `what`: method, iterations, light paths. began: std::clock() before the render.
inline void trace_render(const std::string& what, std::clock_t began, const Result& result,
                         const std::vector<Sensor>& sensors) {
  std::string noise;
  for (const Sensor& s : sensors) {
    if (s.count == 0) continue;
    const auto relative = [](double error, double value) {
      return value > 0 ? error / value : error > 0 ? HUGE_VAL : 0;
    };
    double worst = 0;
    for (const ups_meter_reading& r : result.readings(s))
      worst = std::max(worst, relative(r.standard_error_lx, r.illuminance_lx));
    const ups_meter_statistics mean = result.statistics(s);
    char text[96];
    std::snprintf(text, sizeof text, "; %u meters: worst %.2g %%, mean %.2g %%", s.count, 100 * worst,
                  100 * relative(mean.mean_standard_error_lx, mean.mean_lx));
    noise += text;
  }
  std::printf("[ RENDER   ] %.2f s of CPU, %s%s\n", double(std::clock() - began) / CLOCKS_PER_SEC, what.c_str(),
              noise.c_str());
}

}  // namespace ups::test
