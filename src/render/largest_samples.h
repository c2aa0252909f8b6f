// The samples that weigh most in a result's readings, so that each can be traced again alone (ups_replay): where a
// sample came from, kept beside each meter's and pixel's largest, and the choice among all of them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "render/spread.h"
#include "transport/tally.h"
#include "ups/ups_replay.h"

namespace ups {

struct SampleOrigin {
  uint32_t iteration = 0;
  PathNumber path;
};

// What one path brought to a meter or a pixel in one of its visits.
struct Sample {
  float value = 0;  // lx, cd/m2
  SampleOrigin from;
};

// Of one sensor: keeps those of the largest share of their reading; of equal ones the first.
class LargestSamples {
 public:
  static constexpr size_t most = 64;

  LargestSamples(uint32_t sensor, uint64_t seed) : sensor_(sensor), seed_(seed) {}
  // reading, mean: of the meter or pixel, and of its set or image.
  void add(uint32_t index, const Sample& sample, uint32_t visits, double reading, double mean) {
    const double least = std::max(reading, share_of_mean * mean);
    if (!(sample.value > 0 && least > 0) || visits == 0) return;
    ups_sample s{};
    s.seed = seed_;
    s.sensor.v = sensor_;
    s.index = index;
    s.iteration = sample.from.iteration;
    s.walk = sample.from.path.is_light() ? UPS_WALK_LIGHT : UPS_WALK_EYE;
    s.path = sample.from.path.number();
    s.value = sample.value;
    s.share = float(double(sample.value) / visits / least);
    if (kept_.size() == most && !precedes(s, kept_.back())) return;
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), s, precedes), s);
    if (kept_.size() > most) kept_.pop_back();
  }
  std::vector<ups_sample> take() { return std::move(kept_); }

 private:
  static bool precedes(const ups_sample& a, const ups_sample& b) {
    return std::make_tuple(-a.share, a.index) < std::make_tuple(-b.share, b.index);
  }
  const uint32_t sensor_;  // its id's number
  const uint64_t seed_;
  std::vector<ups_sample> kept_;  // the largest first
};

}  // namespace ups
