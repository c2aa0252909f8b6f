// See reading_warnings.h.
#include "render/reading_warnings.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace ups {

namespace {

// Of exact light, the share that what was not found by chance may be without a word.
constexpr double negligible = 0.01;
// Of a set, the share of meters with heavy tails that is no chance: of Gaussian batches 1 in 1000 has such a kurtosis.
constexpr double many = 0.05;

std::string listed(const std::vector<size_t>& meters) {
  constexpr size_t most = 5;
  std::string text;
  for (size_t i = 0; i < std::min(most, meters.size()); ++i) text += (i ? ", " : "") + std::to_string(meters[i]);
  return meters.size() > most ? text + ", ..." : text;
}

// what: of so many meters.
template <class Holds, class What>
std::string line(uint32_t set_id, const MeterSet& all, const MeterSetReading& set, const Holds& holds,
                 const What& what) {
  std::vector<size_t> meters;
  for (size_t m = 0; m < set.meters.size(); ++m)
    if (holds(set.flags[m], set.meters[m])) meters.push_back(all.number(m));
  if (meters.empty()) return {};
  return "meters " + std::to_string(set_id) + ": " + std::to_string(meters.size()) + " of " +
         std::to_string(set.meters.size()) + " (indices " + listed(meters) + ") " + what(meters.size()) + "\n";
}

// Rare bright light that many meters of a set have met is there for the others, too.
std::string unreliable(size_t meters, size_t of) {
  std::string text = "have unreliable intervals: a few bright paths made much of what was found";
  if (meters < of && double(meters) > many * double(of))
    text += ", and the others may only have been spared such paths so far";
  text += "; see ups_result_read_meter_flags";
  return text;
}

}  // namespace

std::string reading_warnings(uint32_t set_id, const MeterSet& meters, const MeterSetReading& set) {
  return line(
             set_id, meters, set,
             [](uint32_t flags, const ups_meter_reading& r) {
               return (flags & UPS_READING_FEW_PATHS) && r.error_bound_lx > negligible * double(r.illuminance_lx);
             },
             [](size_t) {
               return "have light that no path or too few have found: their standard errors are -1, their bounds those "
                      "of the rule of three";
             }) +
         line(
             set_id, meters, set,
             [](uint32_t flags, const ups_meter_reading&) {
               return (flags & (UPS_READING_SINGLE_PATH | UPS_READING_HEAVY_TAIL)) != 0;
             },
             [&](size_t count) { return unreliable(count, set.meters.size()); });
}

std::string blur_notice(uint32_t camera_id, const ImageReading& image) {
  constexpr double least = 0.2, errors = 3;  // of a tile's luminance; of its bias, about twice those of luminance
  if (image.bias.empty()) return {};
  size_t pixels = 0;
  for (uint32_t top = 0; top < image.height; top += Units::side)
    for (uint32_t left = 0; left < image.width; left += Units::side) {
      double light = 0, bias = 0, variance = 0;
      size_t count = 0;
      for (uint32_t y = top; y < std::min(top + Units::side, image.height); ++y)
        for (uint32_t x = left; x < std::min(left + Units::side, image.width); ++x, ++count) {
          const size_t p = size_t(y) * image.width + x;
          light += image.luminance_rgb[3 * p + 1];
          bias += image.bias[p];
          variance += std::pow(2 * std::max(0.0f, image.standard_error_rgb[3 * p + 1]), 2);
        }
      if (-bias > least * light && bias * bias > errors * errors * variance) pixels += count;
    }
  if (pixels == 0) return {};
  return "camera " + std::to_string(camera_id) + ": the merge radius that was asked for is wider than what about " +
         std::to_string(pixels) + " of its " + std::to_string(size_t(image.width) * image.height) +
         " pixels see: they are too dark by more than their bounds; without it the scene decides\n";
}

std::string crowd_notice(const WorkCounts& work) {
  if (work.crowds == 0) return {};
  return "merging: at " + std::to_string(work.crowds) + " of the places that eye paths met there were very many photons, "
         "up to " + std::to_string(work.largest_crowd) + ": some of them were merged and count for all, which is right in "
         "the mean, and noisier. Fewer light paths an iteration or a smaller merge radius waste less\n";
}

std::string length_notice(uint32_t longest, const WorkCounts& flux, double emitted_lm) {
  constexpr double least = 1e-6;
  const bool known = flux.light_paths > 0;
  const double cut = known ? flux.flux.cut / (double(flux.light_paths) * emitted_lm) : 0;
  if (longest == 0 || (known && cut < least)) return {};
  return "paths end after " + std::to_string(longest) + (longest == 1 ? " edge" : " edges") +
         ", as was asked for: readings " + (known ? "lack" : "may lack") + " the light that goes on" +
         (known ? ", " + short_number(100 * cut, 2) + " % of what is emitted" : "") + "\n";
}

// What light paths lose is missing from what all surfaces absorb, so in the mean from their illuminances. What eye paths
// lose of their importance is as much of what they find where radiance is the same everywhere.
std::string leaning_notice(const WorkCounts& flux, const WorkCounts& render, double emitted_lm) {
  constexpr double least = 1e-3, errors = 3;
  const bool booked = flux.light_paths > 0;
  const LeaningLoss& lost = booked ? flux.leaning_lm : render.leaning_eye;
  const double all = booked ? double(flux.light_paths) * emitted_lm : double(render.eye_paths);
  if (!(all > 0) || !(emitted_lm > 0)) return {};
  const double share = lost.sum / all;
  if (!(std::abs(share) >= least) || lost.sum * lost.sum < errors * errors * lost.squares) return {};
  return std::string("shading normals that lean from their faces ") + (share > 0 ? "lose " : "add ") +
         short_number(100 * std::abs(share), 2) + " % of the light" + (booked ? ", by which illuminances are too " :
         ", were it even everywhere, by about which meters and pixels read too ") + (share > 0 ? "low" : "high") +
         " in the mean: finer meshes and flatter normal maps err less\n";
}

}  // namespace ups
