// See plan.h: numbers of paths from the scene's sensors.
#include "transport/plan.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "platform/numbers.h"

namespace ups {

namespace {

// Small iterations: many fit into a short time limit, and more of them cost only the build of the photon index.
constexpr uint32_t camera_paths_per_iteration = 1u << 15;
constexpr uint32_t meter_paths_per_iteration = 1u << 14;
constexpr uint32_t max_meters_per_iteration = 1u << 15;
constexpr uint32_t max_meter_samples = 1u << 8;
constexpr uint32_t max_light_paths = 1u << 15;
constexpr uint32_t min_light_paths = 1u << 12;
constexpr uint32_t goniometer_paths = 1u << 16;

}  // namespace

double Plan::radius2_factor(uint32_t visits, double alpha) {
  // The product of the recurrence from i = 1: Gamma(i + alpha) / (Gamma(1 + alpha) Gamma(i + 1)), i = visits + 1.
  const double i = double(visits) + 1;
  return std::exp(platform::log_gamma(i + alpha) - platform::log_gamma(1 + alpha) - platform::log_gamma(i + 1));
}

Plan::AtFloor Plan::at_floor(const std::vector<float>& radii, uint32_t visits, double alpha) const {
  const auto raised = [&](float radius_1, uint32_t n) {
    return radius_1 > 0 && double(radius_1) * radius_1 * radius2_factor(n, alpha) < double(min_radius) * min_radius;
  };
  AtFloor out;
  float smallest = 0;
  for (float r : radii)
    if (raised(r, visits)) {
      ++out.count;
      if (smallest == 0 || r < smallest) smallest = r;
    }
  for (uint32_t last = visits; out.count > 0 && out.since < last;) {  // raised at last, not before since
    const uint32_t middle = out.since + (last - out.since) / 2;
    if (raised(smallest, middle))
      last = middle;
    else
      out.since = middle + 1;
  }
  return out;
}

Units::Units(const Snapshot& scene) {
  for (const Camera& c : scene.cameras) {
    begins_.push_back(count);
    widths_.push_back(c.width());
    columns_.push_back((c.width() + side - 1) / side);
    count += columns_.back() * ((c.height() + side - 1) / side);
  }
  for (size_t s = 0; s < scene.meter_sets.size(); ++s) begins_.push_back(count++);
  begins_.push_back(count);
}

bool Plan::traces_caustics_alone() const {
  return !shares.empty() && std::none_of(shares.begin(), shares.end(), [](const TechniqueShare& s) {
    return s.connect || s.light || s.merge == TechniqueShare::merge_all;
  });
}

void set_path_counts(const Snapshot& scene, const TransportSettings& settings, uint32_t most, Plan& plan) {
  const uint64_t pixels = scene.pixel_count(), meters = scene.meter_count(),
                 camera_paths = std::min(most, camera_paths_per_iteration),
                 meter_paths = std::min(most, meter_paths_per_iteration),
                 most_meters = std::min(most, max_meters_per_iteration);
  // Odd, as those of meters below: each pixel meets all batches of the light paths.
  if (pixels > 0) plan.camera_subsets = uint32_t((pixels + camera_paths - 1) / camera_paths) | 1u;
  if (meters > 0) {
    const uint64_t share = std::max<uint64_t>(1, meter_paths / meters);
    plan.meter_samples = uint32_t(std::min<uint64_t>(std::bit_floor(share), max_meter_samples));
    // Odd, so that a meter's batches meet all batches of the light paths: their number is a power of two, and each may
    // have rays of its own of a file. A pilot's meters are among those of the plan's first iteration.
    if (meters > most_meters) {
      const uint32_t subsets = uint32_t((meters + most_meters - 1) / most_meters) | 1u;
      plan.meter_subsets *= (subsets + plan.meter_subsets - 1) / plan.meter_subsets | 1u;
    }
  }
  if (!settings.traces_light()) return;
  const bool goniometers = !scene.goniometers.empty();
  const uint64_t eye = goniometers ? goniometer_paths
                                   : pixels / plan.camera_subsets + meters / plan.meter_subsets * plan.meter_samples;
  const uint32_t least = std::min(most, min_light_paths), largest = goniometers ? goniometer_paths : max_light_paths;
  plan.light_paths = uint32_t(std::clamp<uint64_t>(std::bit_ceil(eye), least, std::min(most, largest)));
}

size_t Plan::bytes() const {
  size_t sum = guide.bytes() + gates.size() * sizeof(mis::Gates) + shares.size() * sizeof(TechniqueShare) +
               separation.columns.size() * sizeof(ups_source_info) +
               separation.column_of_emitter.size() * sizeof(uint32_t);
  for (const auto& radii : pixel_radius) sum += radii.capacity() * sizeof(float);
  for (const MeterDiscs& discs : meter_discs) sum += discs.bytes();
  return sum;
}

size_t ring_rows(const Snapshot& scene, const Separation& separation) {
  size_t points = 0;
  for (const MeterSet& set : scene.meter_sets) points += set.is_cell() ? 0 : set.meters.size();
  return points * (separation.columns.size() + 1);
}

namespace {

// Hits of dim ones do not tell that bright ones would have been found.
std::vector<bool> bright_emitters(const EmitterSet& emitters) {
  std::vector<double> cd_m2;
  for (size_t i = 0; i < emitters.size(); ++i) cd_m2.push_back(emitters[i].brightest_cd_m2());
  std::vector<bool> bright;
  const double most = cd_m2.empty() ? 0 : *std::max_element(cd_m2.begin(), cd_m2.end());
  for (const double own : cd_m2) bright.push_back(own > 0 && 8 * own >= most);
  return bright;
}

}  // namespace

Plan make_plan(const Snapshot& scene, const TransportSettings& settings) {
  Plan plan;
  plan.separation = separate(scene, settings.separation);
  plan.units = Units(scene);
  set_path_counts(scene, settings, UINT32_MAX, plan);
  if (settings.traces_light() && settings.light_paths) plan.light_paths = std::bit_ceil(settings.light_paths);
  plan.min_radius = 32 * 0x1p-24f * scene.radius;
  plan.images_suffice = scene.effects.images_suffice && settings.has(UPS_TECHNIQUE_MIRROR_SAMPLE);
  plan.lands = settings.has(UPS_TECHNIQUE_SENSOR_HIT);
  plan.seeks_caustics = scene.effects.sharp_caster && !plan.images_suffice && settings.max_path_length != 1;
  plan.hits_alone = scene.effects.sharp_caster && !plan.images_suffice && settings.has(UPS_TECHNIQUE_EMITTER_HIT) &&
                    !settings.method.hits_after_specular;
  if (plan.hits_alone && !scene.meter_sets.empty()) plan.counts_hits = bright_emitters(scene.emitters);
  // Nothing but light paths carries a ray emitter's light, from its first surface on.
  const bool samples = settings.has(UPS_TECHNIQUE_LIGHT_SAMPLE);
  for (size_t i = 0; i < scene.emitters.size(); ++i) {
    const bool open = !samples || !scene.emitters[i].is_direct();
    plan.gates.push_back({open, open});
    plan.exact.push_back(scene.emitters[i].is_delta() && scene.emitters[i].is_direct() &&
                         (samples ? !open : settings.method.eye_end == Method::EyeEnd::first_surface));
  }
  return plan;
}

}  // namespace ups
